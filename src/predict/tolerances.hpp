/// \file
/// The tolerances of predictions: unit, value, reason.
#pragma once

#include "math/tolerances.hpp"

#include <cstdint>

namespace carom {

/// Reach of a grid [sum of the largest radii, swept]: five times the 0.2 % of `cell_slack`, beside which rounding is
/// nothing.
inline constexpr double reach_slack = 1.01;

// Lists of neighbours.

/// Distance [mean radius] by which lists reach further at a packing fraction of 1/2.
inline constexpr double shell_at_half = 0.9;
/// Power [1] of the fraction with which it shrinks: 0.65 diameters at 0.3.
inline constexpr double shell_exponent = 0.7;
/// Packing fraction [1] for which lists are made where bodies may gather: that of the densest liquid.
inline constexpr double liquid_fraction = 0.3;
/// Packing fraction [1] below which lists are not made wider: they would hold some 100 neighbours.
inline constexpr double sparsest_lists = 0.01;
/// Part of the escape radius [1] by which the centre of a body that is filed lies ahead of it: 0.15 is best in a dense
/// fluid, 0.4 in a thin one.
inline constexpr double ahead = 0.3;
/// Part of the escape radius [1] that is for the part of a way that is not straight.
inline constexpr double bent_part = 1.0 / 8;

// Tracks (tracks.hpp): what they leave out must be certain, for the exact kernel as it rounds.

/// Widening of a radius [1]: the gap of two bodies that are a few radii apart rounds by 20 u of it in either kernel.
/// Wider costs exact looks: pairs that come nearer than this without touching.
inline constexpr double reach_inflation = 0x1p-30;
/// Rounding of a place [|r| and the way to the common moment]: place 2, way 4, sum 1, the time 2 of the way, difference
/// of two 1, the same once more for the exact kernel, 20 counted, times sqrt 3 for the distance.
inline constexpr double place_rounding = 64 * unit_roundoff;
/// Square of a relative speed [squares of a body's and of what gravity adds to it] of which rounding is certainly less
/// than 2^-30: that of two bodies is 2 u of each in either kernel, so that 2^60 times its square is below 2^-38.
inline constexpr double speed_rounding = 0x1p-36;
/// Part [1] of the square of a distance by which a path that is off by 2^-30 of its length reaches too little: three
/// paths, twice in the square, come to 2^-27.
inline constexpr double track_rounding = 0x1p-26;
/// Square of the cosine [1] between distance and velocity above which two bodies in reach separate: it is off by 2^-28
/// at most.
inline constexpr double certain_separation = 0x1p-50;
/// Error of a normal speed [|v|]: n.v 5 u in either kernel. No derivation of the rest.
inline constexpr double direction_rounding = 0x1p-45;
/// Changes of flights for each body [1] after which the common moment of all tracks moves on: it costs 80 instructions
/// a body, and so 20 an impact.
inline constexpr std::int64_t changes_a_moment = 8;

}  // namespace carom
