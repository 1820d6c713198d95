/// \file
/// A number with a bound on its error, and how an exact value replaces it.
#pragma once

#include "math/dyadic.hpp"
#include "toi/tolerances.hpp"

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
    out.error = rounding_of_exact * std::abs(out.value.high);
    if (std::abs(out.value.high) < exact_may_underflow) {
        const bool is_exact = shift == 0 && (exact - Dyadic(out.value)).sign() == 0;
        out.error = is_exact ? 0 : out.error + smallest_step;
    }
    return out;
}

/// A bound that covers its own rounding.
inline double padded(double a)
{
    return a + bound_padding * a;
}

}  // namespace carom
