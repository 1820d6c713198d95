/// \file
/// Impact of several contacts at one instant (docs/impacts.md, section 3) by their impulses alone: c = c0 + G x.
#pragma once

#include "reference/operators.hpp"

#include <algorithm>

namespace carom::reference {

/// Contacts after a jam was projected away: column j is A K_j.
template <class Real>
Matrix<Real> coupling(const Matrix<Real>& G, const Matrix<Real>& K)
{
    Matrix<Real> H(K.size(), Numbers<Real>(K.size(), Real(0)));
    for (std::size_t j = 0; j < K.size(); ++j) {
        const Numbers<Real> image = residual(G, K[j], Numbers<Real>(G.size(), Real(0)));
        for (std::size_t i = 0; i < K.size(); ++i)
            H[i][j] = std::inner_product(K[i].begin(), K[i].end(), image.begin(), Real(0));
    }
    return H;
}

/// sum + K y.
template <class Real>
Numbers<Real> combined(Numbers<Real> sum, const Matrix<Real>& K, const Numbers<Real>& y)
{
    for (std::size_t j = 0; j < K.size(); ++j)
        for (std::size_t i = 0; i < sum.size() && y[j] != 0; ++i) sum[i] += K[j][i] * y[j];
    return sum;
}

/// Contacts that hold one another: mu > 0 in the convex combination of unit columns that is nearest to 0, if that is 0.
template <class Real>
Chosen jammed(const Matrix<Real>& H, Patience& patience)
{
    const std::size_t n = H.size();
    Matrix<Real> Q = H;  // of min |A mu|^2 + (1 - sum mu)^2 over mu >= 0
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) Q[i][j] = 1 + H[i][j] / sqrt(Real(H[i][i] * H[j][j]));
    const Numbers<Real> mu = complement(Q, Numbers<Real>(n, Real(-1)), Real(residual_left), patience);
    const Real sum = std::accumulate(mu.begin(), mu.end(), Real(0));
    Chosen D;
    for (std::size_t i = 0; i < n && 1 - sum <= jam * jam * sum; ++i)
        if (mu[i] > jam_weight * sum) D.push_back(i);
    return D;
}

/// Generalized reflections (Smith, Kaufman, Vouga, Tamstorf, Grinspun, Reflections on simultaneous impact, SIGGRAPH
/// 2012); test for jams and blend with the inelastic answer: this project. \returns impulses
template <class Real>
Numbers<Real> reflections(const ImpactProblem<Real>& problem, Patience& patience)
{
    const Matrix<Real>& G = problem.G;
    const Numbers<Real>&c0 = problem.c, &e = problem.e;
    const std::size_t m = c0.size();
    const Numbers<Real> inelastic = problem.inelastic(patience);
    Real weight = 0, restitution = 0;
    for (std::size_t i = 0; i < m; ++i)
        if (c0[i] < 0) {
            weight -= inelastic[i] * c0[i];
            restitution -= e[i] * inelastic[i] * c0[i];
        }
    if (restitution <= 0) return inelastic;
    restitution /= weight;

    Matrix<Real> K(m, Numbers<Real>(m, Real(0)));
    for (std::size_t i = 0; i < m; ++i) K[i][i] = 1;
    Numbers<Real> x(m, Real(0));
    const auto rates = [&] {
        const Numbers<Real> c = residual(G, x, c0);
        Numbers<Real> seen;
        for (const Numbers<Real>& k : K) seen.push_back(std::inner_product(k.begin(), k.end(), c.begin(), Real(0)));
        return seen;
    };
    Matrix<Real> H = G;
    for (Chosen D = jammed(H, patience); !D.empty() && patience.lasts(); D = jammed(H, patience)) {
        x = combined(x, K, balance(H, rates(), D));
        Matrix<Real> rest;
        for (std::size_t j = 0; j < K.size(); ++j) {
            if (std::count(D.begin(), D.end(), j) > 0) continue;
            const Numbers<Real> along = balance(H, H[j], D), k = combined(K[j], K, along);
            if (residual(H, along, H[j])[j] > jam * jam * H[j][j]) rest.push_back(k);
        }
        K = rest;
        H = coupling(G, K);
    }
    for (std::size_t round = 0;; ++round) {
        const Numbers<Real> c = rates();
        Chosen V;
        for (std::size_t j = 0; j < c.size(); ++j)
            if (c[j] < -problem.least()) V.push_back(j);
        if (V.empty() || !patience.lasts()) break;
        if (round >= most_rounds + more_rounds * m) return inelastic;
        Matrix<Real> columns;
        Numbers<Real> rates_of_V;
        for (const std::size_t j : V) columns.push_back(K[j]), rates_of_V.push_back(c[j]);
        const Numbers<Real> once = complement(coupling(G, columns), rates_of_V, problem.left(), patience);
        x = combined(combined(x, columns, once), columns, once);
    }
    for (std::size_t i = 0; i < m; ++i) x[i] = restitution * x[i] + (1 - restitution) * inelastic[i];
    return x;
}

}  // namespace carom::reference
