/// \file
/// What an impact does to the spheres of a group.
#pragma once

#include "reference/group.hpp"
#include "reference/reflections.hpp"

namespace carom::reference {

/// IMPACTS 1: the pair law, in which e, alpha and attenuation are exact doubles.
template <class Real>
void impact_alone(const Group<Real>& g, std::vector<Vector<Real>>& v)
{
    const Link<Real>& l = g.links[0];
    const Vector<Real> change = velocity_change<Real>(g.relative(l, v), l.n, l.law);
    g.push(v, l, change * -g.reduced_mass(l));
    for (Vector<Real>& each : v) each = each * l.law.attenuation;
}

/// IMPACTS 2: reflections, then what contacts that got an impulse take of the tangential velocity. \returns impulses;
/// none if something approaches after all
template <class Real>
Numbers<Real> impact_together(const Group<Real>& g, std::vector<Vector<Real>>& v)
{
    const Matrix<Real> G = g.coupling();
    const Real scale = largest(v);
    Numbers<Real> e;
    for (const Link<Real>& l : g.links) e.push_back(l.law.restitution);
    Numbers<Real> x = reflections(G, g.rates(v), e, Real(noise * scale));
    g.push(v, x);
    const std::vector<Vector<Real>> normal = v;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Link<Real>& l = g.links[i];
        const Vector<Real> w = g.relative(l, normal);
        if (x[i] > 0) g.push(v, l, (w - along(w, l.n)) * (g.reduced_mass(l) * (l.law.tangential - 1)));
    }
    g.push(v, complement(G, g.rates(v), Real(1e-25 * scale)));
    for (const Real& c : g.rates(v))
        if (c < -1e-9 * scale) x.clear();
    return x;
}

}  // namespace carom::reference
