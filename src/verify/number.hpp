/// \file
/// The three kinds of numbers that examine a gap one after the other: double, double-double, exact. One source for all;
/// errors are bounded by sizes.
#pragma once

#include "math/double_double.hpp"
#include "verify/exact.hpp"
#include "verify/tolerances.hpp"

#include <carom/types.hpp>

#include <type_traits>

namespace carom::verification {

/// x + y as a number N, without error but for double, which drops y.
template <class N>
N joined(double x, double y)
{
    if constexpr (std::is_same_v<N, double>)
        return x;
    else if constexpr (std::is_same_v<N, DoubleDouble>)
        return two_sum(x, y);
    else
        return N(x, y);
}

/// Relative error that a place, a speed or a product of two of them may have, beside the sizes of its parts.
template <class N>
constexpr double rounding = 0;
template <>
inline constexpr double rounding<double> = double_rounding;
template <>
inline constexpr double rounding<DoubleDouble> = double_double_rounding;

inline double rounded(double x)
{
    return x;
}
inline double rounded(const DoubleDouble& x)
{
    return x.high;
}

template <class N>
struct Vector {
    N x, y, z;
};
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
Vec3 rounded(const Vector<N>& a)
{
    return {rounded(a.x), rounded(a.y), rounded(a.z)};
}

}  // namespace carom::verification
