/// \file
/// Roots of polynomials, none of them missed: they are sought in pieces that are monotone.
#pragma once

#include "reference/vector.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace carom::reference {

/// Coefficients, constant first; at least two where roots are asked for.
template <class Real>
using Polynomial = std::vector<Real>;

template <class Real>
Real value(const Polynomial<Real>& p, const Real& t)
{
    Real sum = 0;
    for (auto c = p.rbegin(); c != p.rend(); ++c) sum = sum * t + *c;
    return sum;
}

template <class Real>
Polynomial<Real> derivative(const Polynomial<Real>& p)
{
    Polynomial<Real> d;
    for (std::size_t k = 1; k < p.size(); ++k) d.push_back(p[k] * static_cast<int>(k));
    return d;
}

/// The root between low and high, at which a function has different signs: Newton steps, halved where they leave the
/// bracket. \param at the function and its slope at a time
template <class Real, class At>
Real bracketed_root(const At& at, Real low, Real high)
{
    const bool rises = at(high).first > 0;
    Real t = (low + high) / 2;
    for (int k = 0; k < most_root_steps; ++k) {
        const auto [f, slope] = at(t);
        if (f == 0) return t;
        ((f > 0) == rises ? high : low) = t;
        Real next = slope == 0 ? low : Real(t - f / slope);
        if (!(next > low && next < high)) next = (low + high) / 2;
        const Real moved = abs(next - t);
        t = next;
        if (moved <= last_digit<Real> * abs(t)) break;
    }
    return t;
}
template <class Real>
Real root_between(const Polynomial<Real>& p, const Polynomial<Real>& d, const Real& low, const Real& high)
{
    return bracketed_root<Real>([&](const Real& t) { return std::pair(value(p, t), value(d, t)); }, low, high);
}

/// p(t + 1).
template <class Real>
Polynomial<Real> shifted(Polynomial<Real> p)
{
    for (std::size_t low = 0; low + 1 < p.size(); ++low)
        for (std::size_t k = p.size() - 1; k-- > low;) p[k] += p[k + 1];
    return p;
}

/// p(t scale).
template <class Real>
Polynomial<Real> scaled(Polynomial<Real> p, const Real& scale)
{
    Real power = 1;
    for (Real& c : p) c *= power, power *= scale;
    return p;
}

/// First t in [0, 1] at which p, of a high degree with terms that fade, falls through 0: halves of the interval until
/// p has no root there, or is monotone.
template <class Real>
std::optional<Real> first_fall_in_unit(const Polynomial<Real>& p, int halvings, std::int64_t& roots)
{
    Real sum = 0, change = 0;
    for (std::size_t k = 1; k < p.size(); ++k) {
        sum += abs(p[k]);
        if (k > 1) change += abs(p[k]) * static_cast<int>(k);
    }
    if (abs(p[0]) > sum || p.size() < 2) return std::nullopt;
    if (abs(p[1]) > change) {
        if (p[1] > 0 || p[0] < 0 || value(p, Real(1)) >= 0) return std::nullopt;
        if (p[0] == 0) return Real(0);
        ++roots;
        return root_between(p, derivative(p), Real(0), Real(1));
    }
    if (halvings == 0) return std::nullopt;  // a double root: a graze, not a contact
    const Polynomial<Real> left = scaled(p, Real(0.5));
    std::optional<Real> t = first_fall_in_unit(left, halvings - 1, roots);
    if (t) return *t / 2;
    t = first_fall_in_unit(shifted(left), halvings - 1, roots);
    if (t) return (1 + *t) / 2;
    return std::nullopt;
}

/// The same in [0, end].
template <class Real>
std::optional<Real> first_fall(const Polynomial<Real>& p, const Real& end, std::int64_t& roots)
{
    const std::optional<Real> t = first_fall_in_unit(scaled(p, end), most_halvings, roots);
    return t ? std::optional<Real>(*t * end) : std::nullopt;
}

}  // namespace carom::reference
