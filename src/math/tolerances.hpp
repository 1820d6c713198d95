/// \file
/// The tolerances of numbers: unit, value, reason.
#pragma once

#include <cstdint>

namespace carom {

/// The unit roundoff u [1], half an ulp of 1: a sum, product, quotient or root of doubles is the exact one times
/// (1 + d), |d| <= u, unless it underflows.
inline constexpr double unit_roundoff = 0x1p-53;

/// Squared length [length^2] above which no component's square that underflows counts: it is off by 2^-1075, 2^-175 of
/// the sum.
inline constexpr double smallest_safe_square = 0x1p-900;
/// Squared length [length^2] below which no square and no sum of three overflows: these reach 2^1024.
inline constexpr double largest_safe_square = 0x1p900;

/// Limbs [32 bits] that give a double-double: the first has one bit or more, so that five hold 129, and 2^-104 of the
/// value needs 106.
inline constexpr int most_rounded_limbs = 5;
/// Exponent [bits] in place of all larger ones: doubles end at 2^1024 and 2^-1074, and any int holds it.
inline constexpr std::int64_t beyond_doubles = 1'000'000;

/// Error of a polynomial's sign by Horner's scheme in double-double [sum of the terms' sizes]: each of at most 8 steps
/// multiplies (5 u^2) and adds (3 u^2), 64 u^2 = 2^-100 in all, and coefficients are rounded to 2^-104; 2^-98 has room
/// (src/toi/ERROR_BOUNDS.md, "Unequal accelerations").
inline constexpr double horner_rounding = 0x1p-98;
/// Underflow's part of that error [unit of the largest coefficient]: 2^-1074 a step, magnified by at most
/// (`largest_horner_point`)^8 = 2^160; the rest is slack.
inline constexpr double horner_underflow = 0x1p-900;
/// Point [unit of the polynomial's variable] up to which `horner_underflow` holds; signs farther out are exact ones.
inline constexpr double largest_horner_point = 0x1p20;

/// Steps [1] of Newton's iteration for a guess: 64 halvings of bit patterns exhaust any bracket, 16 are left for steps
/// that shrink it by less. A guess that is no root costs time, never an answer.
inline constexpr int most_guess_steps = 80;
/// Step [1, part of the root] that ends the iteration: 2 u, one ulp, is all that the double next to a root can tell.
inline constexpr double guess_is_found = 2 * unit_roundoff;

/// First distance from a guess [1, part of it] at which a root is looked for: u, for the guess most often is one of the
/// two doubles next to it.
inline constexpr double first_catch = unit_roundoff;
/// Factor [1] by which the distance grows: 13 looks reach `widest_catch`.
inline constexpr double catch_growth = 16;
/// Distance [1, part of the guess] from which on the whole bracket is halved: guess (1 - 2 d) must stay above 0.
inline constexpr double widest_catch = 0.5;

}  // namespace carom
