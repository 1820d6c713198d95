/// \file
/// The law of linear drag in many digits: x = x0 + v0 s + a q and v = v0 d + a s, s = (1 - exp(-k t))/k, q = (t - s)/k,
/// d = exp(-k t).
#pragma once

#include "support/multiprecision.hpp"

namespace carom::test {

template <class Real>
struct DampedTime {
    Real s, q, d;

    /// \pre k > 0. q keeps all digits of Real but log10(1/(k t)).
    DampedTime(const Real& k, const Real& t) : s(-expm1(Real(-k * t)) / k), q((t - s) / k), d(exp(Real(-k * t))) {}

    Real place(const Real& x, const Real& v, const Real& a) const { return x + v * s + a * q; }
    Real speed(const Real& v, const Real& a) const { return v * d + a * s; }
};

}  // namespace carom::test
