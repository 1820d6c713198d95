/// \file
/// Exponential and logarithm of our own, for double and double-double: sums, products, quotients and powers of two
/// alone, so that every compiler makes the same bits of them. Series of fixed length on reduced arguments.
///
/// Relative errors: exponential 1.5 u (double-double: (16 + 8 |x|) u^2), logarithms 4 u (32 u^2), exponential_tail 3 u
/// (16 u^2); u is `unit_roundoff`. tests/unit/math/test_exponential.cpp measures them.
#pragma once

#include "math/double_double.hpp"
#include "math/limits.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace carom {

namespace detail {

inline constexpr DoubleDouble log_2{log_2_high, log_2_low};

/// `count` reciprocals of `next(n)`, n from 0, each of them rounded once.
template <class Real, int count, class Next>
std::array<Real, count> reciprocals(const Next& next)
{
    std::array<Real, count> out;
    for (int n = 0; n < count; ++n) out[static_cast<std::size_t>(n)] = Real((DoubleDouble(1) / next(n)).high);
    if constexpr (std::is_same_v<Real, DoubleDouble>)
        for (int n = 0; n < count; ++n) out[static_cast<std::size_t>(n)] = DoubleDouble(1) / next(n);
    return out;
}

/// 1 / (n + 2)!. (Factorials are exact up to 32!, which has 118 bits, 31 of them 0 at the end.)
template <class Real>
const std::array<Real, exponential_terms>& inverse_factorials()
{
    static const auto table = reciprocals<Real, exponential_terms>([](int n) {
        DoubleDouble product = 1;
        for (int k = 2; k <= n + 2; ++k) product = product * DoubleDouble(k);
        return product;
    });
    return table;
}

/// 1 / (2 n + 1).
template <class Real>
const std::array<Real, logarithm_terms>& inverse_odd_numbers()
{
    static const auto table = reciprocals<Real, logarithm_terms>([](int n) { return DoubleDouble(2.0 * n + 1); });
    return table;
}

template <class Real, std::size_t count>
Real horner(const std::array<Real, count>& coefficients, Real x)
{
    Real sum = coefficients.back();
    for (std::size_t n = count - 1; n-- > 0;) sum = coefficients[n] + x * sum;
    return sum;
}

inline double head_of(double x)
{
    return x;
}
inline double head_of(DoubleDouble x)
{
    return x.high;
}
inline double times_power_of_two(double x, int exponent)
{
    return std::ldexp(x, exponent);
}
inline DoubleDouble times_power_of_two(DoubleDouble x, int exponent)
{
    return {std::ldexp(x.high, exponent), std::ldexp(x.low, exponent)};
}

/// x - n log 2, |n| < 2^11.
inline double reduced(double x, double n)
{
    return std::fma(-n, log_2.low, std::fma(-n, log_2.high, x));
}
inline DoubleDouble reduced(DoubleDouble x, double n)
{
    return x - DoubleDouble(n) * log_2;
}

/// 2 atanh(w) = log((1 + w) / (1 - w)), |w| <= 1/3.
template <class Real>
Real twice_inverse_tanh(Real w)
{
    return Real(2.0) * (w * horner(inverse_odd_numbers<Real>(), w * w));
}

}  // namespace detail

/// The sum of x^n / (n + 2)! = (e^x - 1 - x) / x^2. \pre |x| <= 1
template <class Real>
Real exponential_tail(Real x)
{
    return detail::horner(detail::inverse_factorials<Real>(), x);
}

/// e^x; 0 where that is below the range of doubles. \pre x <= 709
template <class Real>
Real exponential(Real x)
{
    if (!(detail::head_of(x) > smallest_exponent)) return Real(0.0);
    const double n = std::floor(detail::head_of(x) / detail::log_2.high + 0.5);
    const Real r = detail::reduced(x, n);
    return detail::times_power_of_two(Real(1.0) + (r + (r * r) * exponential_tail(r)), static_cast<int>(n));
}

/// log y. \pre y > 0, finite
template <class Real>
Real logarithm(Real y)
{
    int exponent = 0;
    const double mantissa = std::frexp(detail::head_of(y), &exponent);
    if (mantissa * mantissa < 0.5) --exponent;  // NOLINT: the mantissa lies between the roots of 1/2 and 2
    const Real m = detail::times_power_of_two(y, -exponent);
    const Real log_m = detail::twice_inverse_tanh((m - Real(1.0)) / (m + Real(1.0)));
    if (exponent == 0) return log_m;
    if constexpr (std::is_same_v<Real, double>)
        return exponent * detail::log_2.high + (log_m + exponent * detail::log_2.low);
    else
        return DoubleDouble(exponent) * detail::log_2 + log_m;
}

/// -log(1 - z), without cancellation for small z. \pre 0 <= z < 1
template <class Real>
Real minus_log_of_rest(Real z)
{
    if (detail::head_of(z) <= logarithm_near_1) return detail::twice_inverse_tanh(z / (Real(2.0) - z));
    return -logarithm(Real(1.0) - z);
}

}  // namespace carom
