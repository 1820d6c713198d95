/// \file
/// Many digits, for oracles: exact on sums of products of doubles, far beyond double-double.
#pragma once

#include <carom/types.hpp>

#include <array>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <limits>

namespace carom::test {

template <unsigned Digits>
using Float = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<Digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

using Float200 = Float<200>;
using Float700 = Float<700>;

template <class Real>
using Real3 = std::array<Real, 3>;

template <class Real>
Real3<Real> lift(const Vec3& a)
{
    return {Real(a.x()), Real(a.y()), Real(a.z())};
}
template <class Real>
Real dot(const Real3<Real>& a, const Real3<Real>& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// |t - exact| in units of the last place of `exact`; 0 for 0 is right, anything else for 0 is infinitely wrong.
template <class Real>
double ulps(double t, const Real& exact)
{
    const double rounded = exact.template convert_to<double>();
    if (rounded == t && exact == Real(t)) return 0;
    const double next = std::nextafter(std::abs(rounded), std::numeric_limits<double>::infinity());
    const Real ulp = Real(next) - Real(std::abs(rounded));
    return Real(abs(Real(t) - exact) / ulp).template convert_to<double>();
}

}  // namespace carom::test
