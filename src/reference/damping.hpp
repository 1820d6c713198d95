/// \file
/// Motion with linear drag, dv/dt = a - k v, in closed form: after t the way is v s + a q, the change of velocity
/// s (a - k v), with s = (1 - exp(-k t)) / k and q = (t - s) / k; without drag t and t^2 / 2.
#pragma once

#include "reference/limits.hpp"

#include <cmath>
#include <optional>

namespace carom::reference {

template <class Real>
struct Damped {
    Real s, q;
};

/// Where k t is small q is the sum of its series, t^2 (1/2! - k t / 3! + ...), and s = t - k q: nothing cancels.
template <class Real>
Damped<Real> damped(const Real& k, const Real& t)
{
    using std::abs, std::expm1;
    if (k == 0) return {t, t * t / 2};
    const Real x = k * t;
    if (abs(x) >= series_damping) {
        const Real s = -expm1(-x) / k;
        return {s, (t - s) / k};
    }
    Real sum = 0, term = 0.5;
    for (int n = 3; abs(term) > last_digit<Real>; ++n) sum += term, term *= -x / n;
    const Real q = t * t * sum;
    return {t - k * q, q};
}

/// The time in which s comes to a value; none if that takes for ever.
template <class Real>
std::optional<Real> time_of(const Real& k, const Real& s)
{
    if (k == 0) return s;
    return k * s < 1 ? std::optional<Real>(-log1p(-k * s) / k) : std::nullopt;
}

}  // namespace carom::reference
