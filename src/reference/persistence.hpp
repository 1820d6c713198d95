/// \file
/// Forces in contacts that persist, as far as they leave flights parabolas.
#pragma once

#include "reference/group.hpp"

namespace carom::reference {

template <class Real>
struct Persistence {
    std::vector<Vector<Real>> v, a;  ///< of the bodies from here on
    std::vector<bool> persists;      ///< by link
    bool turns = false;              ///< a contact carries force while its normal turns: no closed form
};

/// Law: docs/impacts.md, section 6. \param g its links have a gap and a rate of 0, up to rounding
template <class Real>
Persistence<Real> persistence(const Group<Real>& g, std::vector<Vector<Real>> v, const Vector<Real>& gravity,
                              Patience& patience)
{
    const Matrix<Real> G = g.coupling();
    const Real speed = largest(v), pull = size(gravity);
    g.push(v, balance(G, g.rates(v), first(g.links.size())));
    std::vector<Vector<Real>> a(v.size(), gravity);
    Numbers<Real> q = g.rates(a);
    for (std::size_t i = 0; i < q.size(); ++i) {
        const Vector<Real> w = settled(g.relative(g.links[i], v), speed);
        q[i] += dot(w, w) * g.links[i].bend;
    }
    const Numbers<Real> force = complement(G, q, Real(1e-25 * pull), patience), y = residual(G, force, q);
    g.push(a, force);

    Persistence<Real> out{std::move(v), std::move(a), std::vector<bool>(q.size())};
    std::vector<bool> supported(out.v.size());
    for (std::size_t i = 0; i < q.size(); ++i) {
        const Link<Real>& l = g.links[i];
        if (y[i] > noise * pull) continue;
        const bool moves = size(settled(g.relative(l, out.v), speed)) + size(settled(g.relative(l, out.a), pull)) > 0;
        out.persists[i] = l.bend == 0 || !moves;
        if (!out.persists[i] && (force[i] > 0 || y[i] < -1e-25 * pull)) out.turns = true;
        if (!out.persists[i]) continue;
        supported[l.a] = true;
        if (l.b != immovable) supported[l.b] = true;
    }
    for (std::size_t k = 0; k < supported.size(); ++k) {
        if (!supported[k]) continue;
        out.v[k] = settled(out.v[k], speed);
        out.a[k] = settled(out.a[k], pull);
    }
    return out;
}

}  // namespace carom::reference
