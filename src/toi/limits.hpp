/// \file
/// The tolerances of times of impact under linear drag, in double (damped_plane.cpp, damped_sphere_sphere.cpp): unit,
/// value, reason. Counted as those of tolerances.hpp.
#pragma once

#include "math/tolerances.hpp"

namespace carom {

/// Error of a height [|h| + |w| s + |g| q]: 6 for s and q, 1 each for product and two sums, 9 counted. Beyond it the
/// sign is taken in double-double.
inline constexpr double damped_height_rounding = 12 * unit_roundoff;
/// Error of F = |p|^2 - S^2 [p.p + S^2 + reach |p|] and of H = p.w [reach speed]: p is off by 9 u of the reach |r| + s
/// |v| + q |a|, so that p.p is by 18 u reach |p|, squares and sums add 4; w is off by 8 u of the speed; 22 counted.
inline constexpr double damped_gap_rounding = 32 * unit_roundoff;

}  // namespace carom
