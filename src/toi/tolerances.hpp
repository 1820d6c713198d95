/// \file
/// The tolerances of times of impact: unit, value, reason. "Bounds" is src/toi/ERROR_BOUNDS.md, which counts roundings;
/// what is used is at least one part in eight above what is counted, but where it says otherwise.
#pragma once

#include "math/tolerances.hpp"

#include <cstddef>

namespace carom {

// Level 0 of two spheres: B = r.v, C = r.r - S^2, D = A S^2 - K, K = |r x v|^2 in double (Bounds, "Level 0").

namespace level_0 {
/// Error of B [sum |r_i v_i|]: inputs 2 u, product 1, sums 2, 5 counted.
inline constexpr double b_rounding = 8 * unit_roundoff;
/// Error of C [r.r + S^2]: 5 for r.r, 3 for S^2, 1 for the difference, 6 counted.
inline constexpr double c_rounding = 8 * unit_roundoff;
/// Error of D [A S^2 + K]: 9 for A S^2, 3 for K, 1 for the difference, 10 counted.
inline constexpr double d_rounding = 12 * unit_roundoff;
/// Twice the error of a component k_i of the cross product [sum of its products' sizes]: inputs 2, product 1,
/// difference 1, 4 counted, 5 used.
inline constexpr double cross_rounding = 10 * unit_roundoff;
/// Error of a time beside that of B, C and D [1]: 6 for its own roundings, 10 for those of its width (Bounds, "Time").
inline constexpr double time_rounding = 16 * unit_roundoff;
}  // namespace level_0

// Level 1, the same in double-double, where sums round by 3 u^2, products by 5 u^2 (Bounds, "Level 1, spheres").

/// u^2 [1], in which roundings of double-double are counted: Joldes, Muller, Popescu 2017.
inline constexpr double double_double_roundoff = unit_roundoff * unit_roundoff;

namespace level_1 {
/// Error of B [sum |r_i v_i|]: products 5, sums 6, 11 counted.
inline constexpr double b_rounding = 16 * double_double_roundoff;
/// Error of C [r.r + S^2]: 11 for r.r, 5 for S^2, 3 for the difference, 14 counted.
inline constexpr double c_rounding = 24 * double_double_roundoff;
/// Error of D [A S^2 + K]: 24 for A S^2 and 14 for K counted.
inline constexpr double d_rounding = 32 * double_double_roundoff;
/// Twice the error of a component k_i of the cross product [sum of its products' sizes]: products 5, difference 3,
/// twice 8 counted.
inline constexpr double cross_rounding = 20 * double_double_roundoff;
/// The square of that error [square of that sum]: 8 squared counted.
inline constexpr double cross_rounding_square = 100 * double_double_roundoff * double_double_roundoff;
/// The same where a component meets the error of what the caller knows [sum of its products' sizes]. Twice 8 would be
/// counted: less than that is used.
inline constexpr double cross_rounding_of_input = 10 * double_double_roundoff;
/// Error of a time beside that of B, C and D [1]: root 4, difference 3, quotient 10, width 8, below 30 in all.
inline constexpr double time_rounding = 64 * double_double_roundoff;
}  // namespace level_1

/// Underflow's part of the error of B [length^2/time]: three products and two components times at most 2^100, below
/// 2^-970 (Bounds, "Underflow").
inline constexpr double b_underflow = 0x1p-960;
/// Underflow's part of the error of D [length^4/time^2]: 2^-1074 2^202 for A S^2, less for K (Bounds, "Underflow").
inline constexpr double d_underflow = 0x1p-860;

// The range in which a formula holds.

/// Relative error [1] of B, C and D up to which a time and its width come from their quotient: the worst of a quarter
/// is in the derivation (Bounds, "Time").
inline constexpr double quotient_holds_within = 0.25;
/// The same as a multiple [errors]: B, C and D are that far from 0.
inline constexpr double quotient_holds_from = 1 / quotient_holds_within;
/// Part [1] of S^2 below which C, and of A S^2 below which D, is mostly cancellation: a time of level 0 would keep less
/// than 53 - 10 - 4 bits, long before the decision is lost.
inline constexpr double cancelled_below = 0x1p-10;
/// Relative error [1] beyond which a value is not worth its place in a double-double formula: a time made of three
/// better ones is within 2^-70, and rounds like the exact one but once in 2^17 cases.
inline constexpr double sharp_enough = 0x1p-75;
/// Padding [1] of a bound that is itself computed in double: sums of some 20 positive terms round by less than 2^-47.
inline constexpr double bound_padding = 0x1p-20;
/// Widening [1] of an interval from some 10 operations in double: they round by less than 2^-49.
inline constexpr double interval_slack = 0x1p-40;

// Range.

/// Largest number [length, speed, acceleration] that the public query takes: differences and sums of a few are doubles.
inline constexpr double largest_number = 0x1p1000;
/// Smallest length and speed [unit] whose products of four factors, 2^-400, and their rounding errors are no
/// subnormals.
inline constexpr double smallest_moderate = 0x1p-100;
/// Largest length and speed [unit] whose products of four factors do not overflow.
inline constexpr double largest_moderate = 0x1p100;
/// Smallest r.r + S^2 and v.v [unit^2] of level 0 in blocks: the largest component is then at least 2^-96, above
/// `smallest_moderate`.
inline constexpr double smallest_moderate_square = 0x1p-190;
/// Largest r.r + S^2 and v.v [unit^2] of level 0 in blocks: components are then below 2^95.
inline constexpr double largest_moderate_square = 0x1p190;
/// Smallest height, speed and acceleration [unit] of a plane's quadratic in double: w^2 and its rounding error, 2^-506,
/// are no subnormals.
inline constexpr double smallest_plane_number = 0x1p-200;
/// Largest height, speed and acceleration [unit] of a plane's quadratic in double: w^2 - 2 g h stays below 2^402.
inline constexpr double largest_plane_number = 0x1p200;
/// Size [unit] of B or C, and of all numbers of a plane's query, below which they get a unit of their own: low parts of
/// larger ones' squares, 2^-706, are no subnormals.
inline constexpr double own_unit_below = 0x1p-300;
/// Exponent [bits] of that unit for a plane: what is largest then lies below 2^200, its products far from either end.
inline constexpr int small_query_shift = 500;

// Underflow of results.

/// Loss [unit] of a double that is scaled into the subnormal range, on either side of it: two of their steps.
inline constexpr double smallest_step = 0x1p-1073;
/// Size [unit] of doubles above which scaling loses nothing: subnormals begin at 2^-1022.
inline constexpr double scales_exactly = 0x1p-1000;
/// Size [unit] of double-doubles above which scaling loses nothing: the last bit of the low part is 2^-106 of it.
inline constexpr double double_double_scales_exactly = 0x1p-900;
/// Error of an exact value rounded to a double-double [1]: 2^-104, and one bit more.
inline constexpr double rounding_of_exact = 0x1p-103;
/// Size [unit] of such a value below which its low part may be subnormal: 2^-104 of it is then below 2^-1064.
inline constexpr double exact_may_underflow = 0x1p-960;
/// Underflow's part of the error of scaled numbers and of sums of products of planes [unit]: 2^-1074 for each of at
/// most six parts, with room.
inline constexpr double plane_underflow = 0x1p-1070;
/// Time [natural unit] before which a time of unequal accelerations is found again in seconds: double-double would lose
/// its digits, see `exact_may_underflow`.
inline constexpr double too_early = exact_may_underflow;
/// Exponent [bits] of the last time that is looked at: 2^1024 is no double.
inline constexpr int horizon_exponent = 1023;
/// The last time [unit] that is looked at, beyond every root that a double holds.
inline constexpr double horizon = 0x1p1023;

// Planes (Bounds, "Planes"), p the error of an operation.

/// Relative error of an operation in double [1]: one rounding.
inline constexpr double double_operation_error = unit_roundoff;
/// Relative error of an operation in double-double [1]: that of a quotient, the worst.
inline constexpr double double_double_operation_error = 10 * double_double_roundoff;

/// Error of D [p (w^2 + 2 |g h|)]: a rounding for each product and for the difference, 2 counted.
inline constexpr double plane_d_operations = 4;
/// Error of a time beside that of h, w, g and D [p]: sum, root, products, quotient and the width's own, 8 counted as
/// for spheres.
inline constexpr double plane_time_operations = 16;
/// Error of a height, rate or acceleration from exact numbers [sum of the terms' sizes]: five sums of double-doubles,
/// 15 u^2 counted; products are exact.
inline constexpr double plane_dot_rounding = 24 * double_double_roundoff;
/// Error of a double-double that is taken for a double [1]: its low part.
inline constexpr double low_part = unit_roundoff;

// Unequal accelerations in double (sphere_sphere_accelerated.cpp).

/// Error of F = |p|^2 - S^2 [p.p + S^2 + reach |p|]: p is off by 4 u of the reach |r| + t |v| + t^2 |a| / 2, so that
/// p.p is by 8 u reach |p|; squares and sums add 4; 12 counted. Beyond it the sign is taken in double-double.
inline constexpr double gap_rounding = 16 * unit_roundoff;
/// Error of H = p.w [reach speed]: 4 for p, 2 for w, 3 for product and sums, 9 counted.
inline constexpr double gap_rate_rounding = 16 * unit_roundoff;
/// Steps [1] of a root's refinement: every third one at least halves the bracket, and 64 halvings of bit patterns
/// exhaust any.
inline constexpr int most_refinements = 200;
/// Factor [1] between the ends of a bracket up to which its middle is their mean, beyond it that of their bit patterns:
/// three halvings either way.
inline constexpr double mean_is_middle = 8;
/// End of a bracket [natural unit] below which its middle is the mean though it begins at 0: some 80 halvings exhaust
/// it. No reason is known to prefer it there.
inline constexpr double mean_from_zero = 1e-300;
/// Time [natural unit, in which lengths and accelerations are of order 1] up to which the gap must grow again: its
/// terms overflow long before.
inline constexpr double latest_growth = 0x1p900;

/// Square [contact distances^2] of a distance at a time of impact up to which its direction is a normal: it is 1 where
/// any digit of the contact is left.
inline constexpr double has_contact_digits = 1.5;

/// Square of a distance [square of the contact distance] above which two spheres are apart whatever rounding does: both
/// squares are within 8 roundings, 1e-15.
inline constexpr double clearly_apart = 1 + 1e-12;
/// Square of a contact distance [length^2] above which its roundings are relative: squares of components do not
/// underflow by what could matter.
inline constexpr double least_plain_square = 1e-280;

/// Pairs [1] of a block of the batch: its arrays of 7 inputs and 5 results, 12 KiB, stay in the first cache.
inline constexpr std::size_t batch_block = 128;

}  // namespace carom
