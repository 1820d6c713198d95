/// \file
/// The tolerances of motions and of the questions to them: unit, value, reason. u is `unit_roundoff`.
#pragma once

#include "flight/tolerances.hpp"
#include "toi/tolerances.hpp"

namespace carom {

// One instant, and what is as good as nothing (struct Tolerances has them for a run).

/// Gap [smaller radius] up to which a contact belongs to the instant of another, unless the scene says otherwise: a
/// thousand times the rounding of a gap. Wider ones join strangers: 1e-9 does so 0.7 times in 1e7 impacts at a packing
/// fraction of 0.5.
inline constexpr double default_tie = 1e-12;
/// Speed [v_c] of a contact that neither opens nor closes. No derivation: with the default of v_c a body rises 1e-17 of
/// a radius with it, below the rounding of a place.
inline constexpr double slow_part = 1e-6;
/// Acceleration [gravity] that opens no contact. No derivation: forces are solved to `projection_tolerance`.
inline constexpr double soft_part = 1e-9;

/// Height [radius + cell] of a bounce that is rest. A height is the difference of places that round to u of that, and
/// of the plane's offset, 4 counted. No derivation of the rest of it.
inline constexpr double rest_height = 16 * unit_roundoff;

// Rounding of normal speeds.

/// Error of n.v [|v|]: product 1, sums 2 of sum |n_i v_i| <= |v|, components of n 1, 4 counted.
inline constexpr double normal_speed_rounding = 4 * unit_roundoff;
/// The same, also of n.g [largest component]: |v| is sqrt 3 of it, 7 counted.
inline constexpr double normal_component_rounding = 8 * unit_roundoff;
/// Error of a product of two vectors [sum |x_i y_i|]: product 1, sums 2, inputs 2, 5 counted.
inline constexpr double dot_rounding = level_0::b_rounding;
/// Error of r.v [sum |r_i v_i| and r_max times both speeds]: 5 for the product, 1 for r, 1 for v, whose unit are the
/// speeds, 7 counted.
inline constexpr double approach_rounding = 2 * dot_rounding;

// Two flights at one moment in double (kinematics.cpp).

/// Error of a time since an older start [the time]: product exact, sum and difference 1 each, 2 counted.
inline constexpr double elapsed_rounding = 3 * unit_roundoff;
/// The same [epoch]: 1 for each of the offsets.
inline constexpr double offset_rounding = 2 * unit_roundoff;
/// Error of a relative place [|r| + cell + way]: way 4, place 1, difference 1, 6 counted and none in reserve.
inline constexpr double flown_place_rounding = 6 * unit_roundoff;
/// Error of a relative velocity [|v| + speed]: product, sum and difference 1 each, 3 counted.
inline constexpr double flown_speed_rounding = 4 * unit_roundoff;
/// Error of a height above a plane [height + cell]: 1 for what Dot2 leaves, 1 for the difference, 1 for the place, 1
/// for the normal, 4 counted.
inline constexpr double height_rounding = 8 * unit_roundoff;
/// Bound [length^2/time] of r.v that is certain: what products lose to underflow, 2^-1074, is nothing beside it. Any
/// number far above that would do.
inline constexpr double least_certain = 0x1p-900;
/// Error of a wait [the wait and an epoch] that is compared with a limit: between() and after() 1 of their sizes and 1
/// of an epoch each, 4 counted.
inline constexpr double wait_rounding = 8 * unit_roundoff;
/// Reach [1] of two bodies that cannot meet in time: way, distance and their squares round by some 10 u. Any number
/// between would do.
inline constexpr double way_slack = 1 + 1e-9;

// The same in double-double, for certified runs.

/// Error of what a few operations make of places, speeds and radii [their sizes]: 14 u^2 counted for r.r - S^2, the
/// longest; this is 64 u^2.
inline constexpr double double_double_error = 0x1p-100;
/// Error of places that are themselves flown to a moment [|r| + cell], where the exact ones are not asked. No
/// derivation: a thousand times `double_double_error`.
inline constexpr double flown_to_rounding = 0x1p-90;
/// Error of velocities that are themselves flown to a moment [speeds]: each is rounded to a double, 1 counted.
inline constexpr double flown_to_speed_rounding = 2 * unit_roundoff;

// Low bounces on a fixed sphere (low_return.cpp).

/// Gap [S + cell] of two spheres that touch: places 2, difference 1, norm 3 and distance 1, 7 counted.
inline constexpr double touching = 8 * unit_roundoff;
/// Change of the normal acceleration during a bounce [1, of that acceleration] up to which it is low: Newton's method
/// then begins with two digits. A vertical one is lower than S / 128.
inline constexpr double low_turn = 1.0 / 64;
/// Steps [1] of Newton's method from there: 4 leave (1/64)^16.
inline constexpr int return_steps = 4;

// Times (clock.hpp).

/// Resolution of times [epochs]: the ulp of an offset just below an epoch.
inline constexpr double time_resolution = unit_roundoff;
/// Steps of the resolution [1] from a time to one certainly before it: after() rounds by 2, and an exact time is
/// stepped back once or twice where places are rounded into an overlap. No derivation of the rest.
inline constexpr int rough_steps = 6;
/// Steps of the resolution [1] back to the latest time that is not too late. No derivation: a bound of the loop, for
/// shifted() leaves a few.
inline constexpr int most_late_steps = 16;
/// Steps of the resolution [1] back out of an overlap, which is one of 2^-100 or so. No derivation: a bound of the
/// loop; one should do.
inline constexpr int most_steps_outside = 8;

// Series (series.cpp).

/// Doublings [1] of a number of bounces, a bound of the loop: with e = 1 - u, the largest, all but e^-64 of the
/// duration is over after 2^59 bounces.
inline constexpr int most_doublings = 62;

// Steps of numeric clusters (numeric_cluster.cpp).

/// Time [step] within which an opening is one of the step's beginning. No derivation.
inline constexpr double at_once = 1e-6;
/// Halvings [1] of a step whose middle stages disagree: down to 1/64. No derivation: a bound of the loop.
inline constexpr int most_halvings = 6;
/// Steps [1] of false position to an opening: halving alone would take 53, Illinois takes about 10.
inline constexpr int most_opening_steps = 60;
/// Acceleration [opening] beyond opening at which a contact is open. No derivation.
inline constexpr double opened_enough = 1e-3;

}  // namespace carom
