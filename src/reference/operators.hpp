/// \file
/// The impact operators but reflections, by their impulses alone (docs/impacts.md, section 3): c = c0 + G x.
#pragma once

#include "reference/cone.hpp"

namespace carom::reference {

/// Several contacts that close at one instant.
template <class Real>
struct ImpactProblem {
    Matrix<Real> G;      ///< coupling of the contacts
    Numbers<Real> c, e;  ///< rates before, restitutions
    Real closing = 0;    ///< the fastest of the rates that close

    Real least() const { return least_closing * closing; }  ///< what counts as closing
    Real left() const { return residual_left * closing; }   ///< what may close after a projection
    Numbers<Real> inelastic(Patience& patience) const { return complement(G, c, left(), patience); }
};

/// The pair law in the order of the contacts, again and again (Hahn 1988; Moore and Wilhelms 1988). Where that does not
/// end, or all rates vanish, the inelastic answer.
template <class Real>
Numbers<Real> sequential(const ImpactProblem<Real>& p, Patience& patience)
{
    const std::size_t m = p.c.size(), most = most_impulses + more_impulses * m;
    Numbers<Real> x(m, Real(0)), c = p.c;
    std::size_t impulses = 0;
    for (bool closes = true; closes && patience.lasts();) {
        closes = false;
        for (std::size_t i = 0; i < m; ++i) {
            if (c[i] >= -p.least()) continue;
            if (++impulses > most) return p.inelastic(patience);
            closes = true;
            const Real impulse = -(1 + p.e[i]) * c[i] / p.G[i][i];
            x[i] += impulse;
            for (std::size_t j = 0; j < m; ++j)
                if (p.G[i][j] != 0) c[j] += p.G[i][j] * impulse;
        }
    }
    return x;
}

/// 0 <= x, c+ + e c >= 0, complementary (Moreau 1988).
template <class Real>
Numbers<Real> newton(const ImpactProblem<Real>& p, Patience& patience)
{
    Numbers<Real> c = p.c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] *= 1 + p.e[i];
    return complement(p.G, c, p.left(), patience);
}

/// Compression, then each contact gives back e of its impulse at least (Glocker and Pfeiffer 1995).
template <class Real>
Numbers<Real> poisson(const ImpactProblem<Real>& p, Patience& patience)
{
    Numbers<Real> x = p.inelastic(patience);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] *= 1 + p.e[i];
    const Numbers<Real> expansion = complement(p.G, residual(p.G, x, p.c), p.left(), patience);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += expansion[i];
    return x;
}

}  // namespace carom::reference
