/// \file
/// The tolerances of flights and of the rulers of a run: unit, value, reason.
#pragma once

#include "math/tolerances.hpp"

namespace carom {

/// Number [epochs, cells] beyond which a time or a place has none: 64 bits hold 2^63, and half of that leaves room for
/// sums of two.
inline constexpr double furthest = 0x1p62;

/// Smallest radius and time [length, time] that rulers are cut for: u^2 of it, what double-doubles resolve, is 2^-1006
/// and no subnormal.
inline constexpr double smallest_ruler = 0x1p-900;
/// Largest radius and time [length, time] that rulers are cut for: `furthest` of them, 2^962, are a double.
inline constexpr double largest_ruler = 0x1p900;
/// Exponent [bits] of the smallest power of two that is a ruler: its reciprocal and its ulp, 2^-1052, are doubles.
inline constexpr int least_exponent = -1000;

/// Gravity along a plane [1, part of gravity] that is rounding, so that what rests on a level floor does not creep: g.n
/// rounds by 3, n.n by 3, quotient and product by 1 each. Components of g and n that are rounded themselves add up to 2
/// more; 300,000 random directions leave 4.8 u at most.
inline constexpr double level_rounding = 8 * unit_roundoff;

}  // namespace carom
