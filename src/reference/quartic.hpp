/// \file
/// First instants of contact where the relative acceleration is not 0, as between a fixed sphere and a falling one:
/// |r + v t + a t^2/2|^2 - sum^2 is a quartic. Its roots are found between those of its derivative, which are found
/// between those of the next one, down to a line: every piece is monotone, so that none is missed.
#pragma once

#include "reference/vector.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace carom::reference {

/// Coefficients, constant first; at least two.
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

/// The root between low and high, at which p has different signs: Newton steps, halved where they leave the bracket.
template <class Real>
Real root_between(const Polynomial<Real>& p, const Polynomial<Real>& d, Real low, Real high)
{
    constexpr int most = 500;  // more than the halvings that 100 digits need
    const bool rises = value(p, high) > 0;
    Real t = (low + high) / 2;
    for (int k = 0; k < most; ++k) {
        const Real f = value(p, t), slope = value(d, t);
        if (f == 0) return t;
        ((f > 0) == rises ? high : low) = t;
        Real next = slope == 0 ? low : Real(t - f / slope);
        if (!(next > low && next < high)) next = (low + high) / 2;
        const Real moved = abs(next - t);
        t = next;
        if (moved <= std::numeric_limits<Real>::epsilon() * abs(t)) break;
    }
    return t;
}

/// Where p changes its sign in (0, end), ascending. `roots` counts brackets solved.
template <class Real>
std::vector<Real> sign_changes(const Polynomial<Real>& p, const Real& end, std::int64_t& roots)
{
    if (p.size() < 2) return {};
    const Polynomial<Real> d = derivative(p);
    std::vector<Real> ends{Real(0)}, found;
    for (const Real& t : sign_changes(d, end, roots)) ends.push_back(t);
    ends.push_back(end);
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const Real f = value(p, ends[k - 1]), g = value(p, ends[k]);
        if (!((f < 0 && g > 0) || (f > 0 && g < 0))) continue;
        ++roots;
        found.push_back(root_between(p, d, ends[k - 1], ends[k]));
    }
    return found;
}

/// First t in [0, end) at which |r + v t + a t^2/2| = sum and falling. Closed and still, pressed together by `a`: 0.
template <class Real>
std::optional<Real> accelerated_contact(const Vector<Real>& r, const Vector<Real>& v, const Vector<Real>& a,
                                        const Real& sum, const Real& end, std::int64_t& roots)
{
    const Real scale = sum * sum, rr = dot(r, r), rv = snapped(dot(r, v), sum * size(v));
    Polynomial<Real> p{snapped(rr - scale, scale), 2 * rv, snapped(dot(v, v) + dot(r, a), sum * size(a)), dot(v, a),
                       dot(a, a) / 4};
    if (p[0] <= 0) {  // closed: now if it falls, else after it has opened
        if (rv < 0 || (rv == 0 && p[2] < 0)) return Real(0);
        if (p[0] == 0) p.erase(p.begin());
    }
    for (const Real& t : sign_changes(p, end, roots))
        if (value(derivative(p), t) < 0) return t;
    return std::nullopt;
}

}  // namespace carom::reference
