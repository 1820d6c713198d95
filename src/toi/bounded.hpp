/// \file
/// A number with a bound on its error, and how an exact value replaces it.
#pragma once

#include "math/dyadic.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

inline double head(double x)
{
    return x;
}
inline double head(DoubleDouble x)
{
    return x.high;
}

/// |value - exact| <= error.
template <class Number>
struct BoundedNumber {
    Number value{};
    double error = 0;
    int sign = 0;       ///< of the exact value, unless it is open
    bool open = false;  ///< the bound does not tell the sign

    BoundedNumber() = default;
    BoundedNumber(Number v, double e) : value(v), error(e)
    {
        sign = head(v) > e ? 1 : head(v) < -e ? -1 : 0;
        open = sign == 0 && !(e == 0 && head(v) == 0);
    }

    bool is_negative() const { return !open && sign < 0; }
    bool is_positive() const { return !open && sign > 0; }
    bool is_zero() const { return !open && sign == 0; }
    bool at_most_zero() const { return !open && sign <= 0; }
    bool at_least_zero() const { return !open && sign >= 0; }

    /// Nothing smaller is known to be meant.
    double size() const { return std::max(std::abs(head(value)), error); }
};
using Bounded = BoundedNumber<DoubleDouble>;

/// Beyond this relative error a value is not worth its place in a double-double formula: a time made of three better
/// ones is within 2^-70, and rounds like the exact one but once in 2^17 cases.
inline constexpr double sharp_enough = 0x1p-75;

/// \param scale what the error is held against, >= 0
inline bool is_blunt(const Bounded& x, double scale)
{
    return x.open || x.error > sharp_enough * scale;
}

/// The exact value times 2^shift. Its sign is right even where its value underflows.
inline Bounded settled(const Dyadic& exact, int shift)
{
    Bounded out;
    out.value = exact.rounded(shift);
    out.sign = exact.sign();
    constexpr double small = 0x1p-960, underflow = 0x1p-1073;
    out.error = 0x1p-103 * std::abs(out.value.high);
    if (std::abs(out.value.high) < small) {
        const bool is_exact = shift == 0 && (exact - Dyadic(out.value)).sign() == 0;
        out.error = is_exact ? 0 : out.error + underflow;
    }
    return out;
}

/// a (1 + 2^-20): covers the rounding of a bound that is itself computed in double.
inline double padded(double a)
{
    return a + 0x1p-20 * a;
}

}  // namespace carom
