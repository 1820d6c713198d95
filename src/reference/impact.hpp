/// \file
/// The impact of one contact and of several, on the spheres of a group.
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
/// a body has k of them 1/k of that, so that together they give no energy. \param least speed that is none
template <class Real>
void rub(const Group<Real>& g, std::vector<Vector<Real>>& v, const Numbers<Real>& x, const Real& least)
{
    const std::vector<Vector<Real>> before = v;
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

/// Impulses of an operator. \pre it is one that the reference has, see `has_operator`
template <class Real>
Numbers<Real> impulses(ImpactOperator which, LcpLaw law, const ImpactProblem<Real>& problem, Patience& patience)
{
    if (which == ImpactOperator::sequential) return sequential(problem, patience);
    if (which == ImpactOperator::lcp)
        return law == LcpLaw::newton ? newton(problem, patience) : poisson(problem, patience);
    return reflections(problem, patience);
}

inline bool has_operator(ImpactOperator which)
{
    return which != ImpactOperator::shock && which != ImpactOperator::jacobi;
}

/// Several contacts (docs/impacts.md, section 3), and a last inelastic impact. \returns impulses; none if something
/// approaches after all
template <class Real>
Numbers<Real> impact_together(const Group<Real>& g, std::vector<Vector<Real>>& v, ImpactOperator which, LcpLaw law,
                              Patience& patience)
{
    ImpactProblem<Real> problem{g.coupling(), g.rates(v), {}, 0};
    for (const Link<Real>& l : g.links) problem.e.push_back(l.law.restitution);
    for (const Real& c : problem.c) problem.closing = std::max<Real>(problem.closing, -c);
    Numbers<Real> x = impulses(which, law, problem, patience);
    g.push(v, x);
    rub(g, v, x, Real(noise * problem.closing));
    g.push(v, complement(problem.G, g.rates(v), problem.left(), patience));
    for (const Real& c : g.rates(v))
        if (c < -unresolved * problem.closing) x.clear();
    return x;
}

}  // namespace carom::reference
