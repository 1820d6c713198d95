/// \file
/// Double-double arithmetic: an unevaluated sum of two doubles, about 106 bits.
/// Algorithms and bounds: Joldes, Muller, Popescu, Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic, ACM TOMS 44 (2017). Relative errors: + and - 3 u^2, * 5 u^2, / 10 u^2, sqrt 4 u^2 or less.
#pragma once

#include "math/error_free.hpp"

#include <cmath>

namespace carom {

struct DoubleDouble {
    double high = 0, low = 0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double value) : high(value) {}  // NOLINT: a double is a double-double
    constexpr DoubleDouble(double h, double l) : high(h), low(l) {}
    constexpr DoubleDouble(Sum s) : high(s.high), low(s.low) {}  // NOLINT

    explicit constexpr operator double() const { return high + low; }
    constexpr DoubleDouble operator-() const { return {-high, -low}; }
};

/// Sum: AccurateDWPlusDW of the paper.
inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b)
{
    const Sum s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
    const Sum v = fast_two_sum(s.high, s.low + t.high);
    return fast_two_sum(v.high, t.low + v.low);
}
inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b)
{
    return a + (-b);
}

/// Product: DWTimesDW2 of the paper.
inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b)
{
    const Sum p = two_product(a.high, b.high);
    const double cross = std::fma(a.low, b.high, std::fma(a.high, b.low, a.low * b.low));
    return fast_two_sum(p.high, p.low + cross);
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b)
{
    const double q1 = a.high / b.high;
    DoubleDouble rest = a - b * DoubleDouble(q1);
    const double q2 = rest.high / b.high;
    rest = rest - b * DoubleDouble(q2);
    return DoubleDouble(fast_two_sum(q1, q2)) + DoubleDouble(rest.high / b.high);
}

/// The square root; 0 for a <= 0.
inline DoubleDouble sqrt(DoubleDouble a)
{
    if (!(a.high > 0)) return {};
    const double root = std::sqrt(a.high);
    const double rest = std::fma(-root, root, a.high) + a.low;
    return fast_two_sum(root, rest / (2 * root));
}

inline DoubleDouble abs(DoubleDouble a)
{
    return a.high < 0 || (a.high == 0 && a.low < 0) ? -a : a;
}
inline bool operator<(DoubleDouble a, DoubleDouble b)
{
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator>(DoubleDouble a, DoubleDouble b)
{
    return b < a;
}
inline bool operator<=(DoubleDouble a, DoubleDouble b)
{
    return !(b < a);
}
inline bool operator>=(DoubleDouble a, DoubleDouble b)
{
    return !(a < b);
}

/// Three components in double-double.
struct DoubleDouble3 {
    DoubleDouble x, y, z;
};
inline DoubleDouble3 operator+(const DoubleDouble3& a, const DoubleDouble3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline DoubleDouble3 operator-(const DoubleDouble3& a, const DoubleDouble3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline DoubleDouble3 operator*(DoubleDouble s, const DoubleDouble3& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
inline DoubleDouble dot(const DoubleDouble3& a, const DoubleDouble3& b)
{
    return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
inline DoubleDouble3 cross(const DoubleDouble3& a, const DoubleDouble3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace carom
