/// \file
/// The limits of exponential and logarithm (exponential.hpp): unit, value, reason. Lengths of series are the same for
/// double and double-double.
#pragma once

namespace carom {

/// Terms [1] of sum x^n / (n + 2)!: at |x| = 1 the first one left out is 1 / 33!, 2^-122.
inline constexpr int exponential_terms = 31;
/// Terms [1] of sum w^2n / (2 n + 1): at |w| = 1/3 the first one left out is 3^-70 / 71, 2^-117.
inline constexpr int logarithm_terms = 35;
/// Exponent [1] below which an exponential is 0: doubles end at e^-745.2.
inline constexpr double smallest_exponent = -746;
/// Argument z [1] up to which log(1 - z) comes from one series: w = z / (2 - z) is 1/3 there.
inline constexpr double logarithm_near_1 = 0.5;

/// log 2 [1], rounded to a double.
inline constexpr double log_2_high = 0x1.62e42fefa39efp-1;
/// What that lacks [1]: with it log 2 is known to 2^-110 of itself.
inline constexpr double log_2_low = 0x1.abc9e3b39803fp-56;

}  // namespace carom
