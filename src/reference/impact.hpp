/// \file
/// What an impact does to the spheres of a group.
#pragma once

#include "reference/group.hpp"
#include "reference/reflections.hpp"

namespace carom::reference {

/// The pair law (docs/impacts.md, section 1), in which e, alpha and attenuation are exact doubles.
template <class Real>
void impact_alone(const Group<Real>& g, std::vector<Vector<Real>>& v)
{
    const Link<Real>& l = g.links[0];
    const Vector<Real> change = velocity_change<Real>(g.relative(l, v), l.n, l.law);
    g.push(v, l, change * -g.reduced_mass(l));
    for (Vector<Real>& each : v) each = each * l.law.attenuation;
}

/// What contacts with an impulse take of the tangential velocities, all at once: -(1 - alpha) m_red v_t each, and where
/// a body has k of them 1/k of that, so that together they give no energy.
template <class Real>
void rub(const Group<Real>& g, std::vector<Vector<Real>>& v, const Numbers<Real>& x)
{
    const std::vector<Vector<Real>> before = v;
    const Real least = noise * largest(v);
    const auto hits = [&](std::size_t body) {
        int k = 0;
        for (std::size_t i = 0; i < x.size() && body != immovable; ++i)
            k += (g.links[i].a == body || g.links[i].b == body) && x[i] > least * g.reduced_mass(g.links[i]);
        return k;
    };
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Link<Real>& l = g.links[i];
        if (!(x[i] > least * g.reduced_mass(l)) || l.law.tangential == 1) continue;
        const Vector<Real> w = g.relative(l, before);
        const Real part = (1 - Real(l.law.tangential)) * g.reduced_mass(l) / std::max(hits(l.a), hits(l.b));
        g.push(v, l, (w - along(w, l.n)) * -part);
    }
}

/// Several contacts (docs/impacts.md, section 3), and a last inelastic impact. \returns impulses; none if something
/// approaches after all
template <class Real>
Numbers<Real> impact_together(const Group<Real>& g, std::vector<Vector<Real>>& v, Patience& patience)
{
    const Matrix<Real> G = g.coupling();
    const Real scale = largest(v);
    Numbers<Real> e;
    for (const Link<Real>& l : g.links) e.push_back(l.law.restitution);
    Numbers<Real> x = reflections(G, g.rates(v), e, Real(noise * scale), patience);
    g.push(v, x);
    rub(g, v, x);
    g.push(v, complement(G, g.rates(v), Real(1e-25 * scale), patience));
    for (const Real& c : g.rates(v))
        if (c < -1e-9 * scale) x.clear();
    return x;
}

}  // namespace carom::reference
