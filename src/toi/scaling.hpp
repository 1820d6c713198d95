/// \file
/// Powers of two as units of length and speed, for squares that would leave the range of doubles.
#pragma once

#include "math/double_double.hpp"
#include "toi/tolerances.hpp"

#include <carom/types.hpp>

#include <algorithm>
#include <cmath>

namespace carom {

/// Products of four such factors, and their rounding errors, neither overflow nor lose bits.
inline bool is_moderate(double x)
{
    return x > smallest_moderate && x < largest_moderate;
}

inline int exponent_of(double x)
{
    int exponent = 0;
    std::frexp(x, &exponent);
    return exponent;
}

inline double largest(const Vec3& a)
{
    return std::max({std::abs(a.x()), std::abs(a.y()), std::abs(a.z())});
}
inline double largest(const DoubleDouble3& a)
{
    return std::max({std::abs(a.x.high), std::abs(a.y.high), std::abs(a.z.high)});
}

inline Vec3 scaled(const Vec3& a, int exponent)
{
    return {std::ldexp(a.x(), exponent), std::ldexp(a.y(), exponent), std::ldexp(a.z(), exponent)};
}
inline DoubleDouble scaled(DoubleDouble a, int exponent)
{
    return {std::ldexp(a.high, exponent), std::ldexp(a.low, exponent)};
}
inline DoubleDouble3 scaled(const DoubleDouble3& a, int exponent)
{
    return {scaled(a.x, exponent), scaled(a.y, exponent), scaled(a.z, exponent)};
}

/// The ends of an interval in another unit: still its ends where they become subnormal.
inline double scaled_down(double low, int exponent)
{
    const double t = std::ldexp(low, exponent);
    return t < scales_exactly ? std::max(t - smallest_step, 0.0) : t;
}
inline double scaled_up(double high, int exponent)
{
    const double t = std::ldexp(high, exponent);
    return t < scales_exactly ? t + smallest_step : t;
}
inline DoubleDouble scaled_down(DoubleDouble low, int exponent)
{
    const DoubleDouble t = scaled(low, exponent);
    if (!(t.high < double_double_scales_exactly)) return t;
    const DoubleDouble less = t - DoubleDouble(smallest_step);
    return less.high > 0 ? less : DoubleDouble(0);
}
inline DoubleDouble scaled_up(DoubleDouble high, int exponent)
{
    const DoubleDouble t = scaled(high, exponent);
    return t.high < double_double_scales_exactly ? t + DoubleDouble(smallest_step) : t;
}

inline DoubleDouble3 exactly(const Vec3& a)
{
    return {a.x(), a.y(), a.z()};
}

}  // namespace carom
