/// \file
/// Forces in contacts that persist, and how their bodies go on where no normal turns.
#pragma once

#include "reference/group.hpp"

namespace carom::reference {

template <class Real>
struct Persistence {
    std::vector<Vector<Real>> v, a;            ///< of the bodies from here on
    std::vector<bool> carries, stays, closed;  ///< by link: has a force; does not open; persists while a is constant
    bool turns = false;                        ///< a contact carries force while its normal turns: a changes
    bool rests = false;                        ///< nothing moves
};

/// Law: docs/impacts.md, section 6. \param g its links have a gap and a rate of 0, up to rounding \param still a speed
/// that is none
template <class Real>
Persistence<Real> persistence(const Group<Real>& g, std::vector<Vector<Real>> v, const Vector<Real>& gravity,
                              const Real& still, Patience& patience)
{
    const Matrix<Real> G = g.coupling();
    const Real pull = size(gravity), speed = std::max<Real>(still, equilibrium * largest(v));
    g.push(v, balance(G, g.rates(v), first(g.links.size())));
    std::vector<Vector<Real>> a(v.size(), gravity);
    Numbers<Real> q = g.rates(a);
    Real scale = pull;
    for (std::size_t i = 0; i < q.size(); ++i) {
        const Vector<Real> w = g.relative(g.links[i], v);
        const Real turning = dot(w, w) * g.links[i].bend;
        q[i] += turning;
        scale = std::max<Real>(scale, turning);
    }
    const Numbers<Real> force = complement(G, q, Real(residual_left * scale), patience), y = residual(G, force, q);
    g.push(a, force);

    Persistence<Real> out{std::move(v), std::move(a), {}, {}, {}};
    for (std::size_t i = 0; i < q.size(); ++i) {
        const Link<Real>& l = g.links[i];
        const bool moves = size(g.relative(l, out.v)) > speed || size(g.relative(l, out.a)) > equilibrium * pull;
        out.carries.push_back(force[i] > 0);
        out.stays.push_back(y[i] <= equilibrium * scale);
        out.closed.push_back(out.stays[i] && (l.bend == 0 || !moves));
        out.turns = out.turns || (out.carries[i] && !out.closed[i]);
    }
    const auto above = [](const Real& least) { return [&least](const Vector<Real>& w) { return size(w) > least; }; };
    const Real least = equilibrium * pull;
    out.rests = !g.links.empty() && std::none_of(out.v.begin(), out.v.end(), above(still)) &&
                std::none_of(out.a.begin(), out.a.end(), above(least));
    return out;
}

}  // namespace carom::reference
