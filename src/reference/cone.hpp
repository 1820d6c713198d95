/// \file
/// Complementarity problems of a few contacts, dense, in multiprecision. G = A^T A is the coupling of contacts.
#pragma once

#include "core/patience.hpp"
#include "reference/limits.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace carom::reference {

template <class Real>
using Numbers = std::vector<Real>;
template <class Real>
using Matrix = std::vector<Numbers<Real>>;
using Chosen = std::vector<std::size_t>;

inline Chosen first(std::size_t n)
{
    Chosen all(n);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

/// G x + c.
template <class Real>
Numbers<Real> residual(const Matrix<Real>& G, const Numbers<Real>& x, Numbers<Real> c)
{
    for (std::size_t i = 0; i < c.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j)
            if (x[j] != 0) c[i] += G[i][j] * x[j];
    return c;
}

/// L D L^T of the rows of G that are chosen. Rows that are sums of rows before them are left out.
template <class Real>
class Factor {
public:
    Factor(const Matrix<Real>& G, Chosen chosen) : chosen_(std::move(chosen)), U_(chosen_.size())
    {
        const std::size_t n = chosen_.size();
        for (std::size_t i = 0; i < n; ++i)
            for (const std::size_t j : chosen_) U_[i].push_back(G[chosen_[i]][j]);
        for (std::size_t k = 0; k < n; ++k) {
            depends_.push_back(U_[k][k] <= dependent * G[chosen_[k]][chosen_[k]]);
            for (std::size_t i = k + 1; i < n && !depends_[k]; ++i) {
                if (U_[k][i] == 0) continue;
                const Real f = U_[k][i] / U_[k][k];
                for (std::size_t j = i; j < n; ++j)
                    if (U_[k][j] != 0) U_[i][j] -= f * U_[k][j];
            }
        }
    }

    bool dependent_rows() const { return std::count(depends_.begin(), depends_.end(), true) > 0; }

    /// x with (G x + c)_i = 0 and x_i = 0 elsewhere, i chosen. What depends on contacts chosen before it gets 0.
    Numbers<Real> balance(const Numbers<Real>& c) const
    {
        const std::size_t n = chosen_.size();
        Numbers<Real> y(n), x(c.size(), Real(0));
        for (std::size_t i = 0; i < n; ++i) y[i] = -c[chosen_[i]];
        for (std::size_t k = 0; k < n; ++k) {
            if (depends_[k] || y[k] == 0) continue;
            const Real f = y[k] / U_[k][k];
            for (std::size_t i = k + 1; i < n; ++i)
                if (U_[k][i] != 0) y[i] -= f * U_[k][i];
        }
        for (std::size_t k = n; k-- > 0;) {
            if (depends_[k]) continue;
            for (std::size_t j = k + 1; j < n; ++j)
                if (U_[k][j] != 0) y[k] -= U_[k][j] * x[chosen_[j]];
            x[chosen_[k]] = y[k] / U_[k][k];
        }
        return x;
    }

private:
    Chosen chosen_;
    Matrix<Real> U_;  ///< D L^T, upper triangle
    std::vector<bool> depends_;
};

template <class Real>
Numbers<Real> balance(const Matrix<Real>& G, const Numbers<Real>& c, const Chosen& chosen)
{
    return Factor<Real>(G, chosen).balance(c);
}

/// x >= 0 with G x + c >= 0 (to `least`) and x.(G x + c) = 0: Lawson and Hanson, Solving Least Squares Problems (1974),
/// chapter 23, on G; first all contacts are tried together. Without patience: what there is by then.
template <class Real>
Numbers<Real> complement(const Matrix<Real>& G, const Numbers<Real>& c, const Real& least, Patience& patience)
{
    const std::size_t m = c.size(), most = most_pivots * (m + 1);
    Numbers<Real> x = balance(G, c, first(m));
    if (std::all_of(x.begin(), x.end(), [](const Real& value) { return value >= 0; })) return x;
    x.assign(m, Real(0));
    Chosen P;
    std::vector<bool> barred(m, false);  // in P, or found to depend on it
    for (std::size_t step = 0; step < most && patience.lasts(); ++step) {
        const Numbers<Real> y = residual(G, x, c);
        std::size_t next = m;
        for (std::size_t i = 0; i < m; ++i)
            if (!barred[i] && y[i] < -least && (next == m || y[i] < y[next])) next = i;
        if (next == m) break;
        P.push_back(next);
        Numbers<Real> z = balance(G, c, P);
        if (z[next] <= 0) {
            P.pop_back();
            barred[next] = true;
            continue;
        }
        while (patience.lasts()) {
            std::size_t blocks = m;
            Real part = 1;
            for (const std::size_t i : P) {
                if (z[i] > 0) continue;
                const Real s = x[i] > z[i] ? Real(x[i] / (x[i] - z[i])) : Real(0);
                if (blocks == m || s < part) part = s, blocks = i;
            }
            for (std::size_t i = 0; i < m; ++i) x[i] += part * (z[i] - x[i]);
            if (blocks == m) break;
            x[blocks] = 0;
            std::erase(P, blocks);
            z = balance(G, c, P);
        }
        barred.assign(m, false);
        for (const std::size_t i : P) barred[i] = true;
    }
    return x;
}

}  // namespace carom::reference
