/// \file
/// The tolerances of contacts that persist: unit, value, reason.
#pragma once

#include "motion/tolerances.hpp"

namespace carom {

// A sphere on one plane.

/// Normal speed [|v|] that is none: twice its rounding.
inline constexpr double no_normal_speed = 2 * normal_speed_rounding;

// Contacts of a component.

/// Gap [rest.gap_tolerance] that needs no closing in contacts of bodies that end a numeric piece: with the default
/// tolerance 1e-12 of a radius, a thousand times the rounding of a gap, as `default_tie`.
inline constexpr double narrow_gap = 1e-3;
/// Speed [largest speed] of a contact that opens: twice what `normal_speed_rounding` makes of it.
inline constexpr double opening_speed = 2 * normal_speed_rounding;
/// Normal [1] of a contact that persists is known to this, about sqrt(2 * 1e-9): spheres that are turned by less are
/// within the tolerance of their gap. So rates are not told apart that differ by it.
inline constexpr double known_normal = 1e-4;

// Low bounces under drag.

/// Growth [exponent of e] of the number of bounces a time until the end of a run, beyond which there are too many of
/// them anyhow: e^50 is 5e21.
inline constexpr double most_growth = 50;

// Numeric steps.

/// Disagreement [smallest radius] of the middle stages of a step, as a distance, see NumericCluster: a ball that rolls
/// off another one under gravity has 1e-8 in a whole step. No derivation, and not measured.
inline constexpr double step_agreement = 3e-7;
/// Length of a step [mean length of the last ones] in heaps that impacts interrupt: what is found for later times is of
/// no use. No derivation.
inline constexpr double step_growth = 4;
/// Shortest such step [numeric_step]: 1/64. No derivation.
inline constexpr double shortest_step = 0x1p-6;

/// Length of a step [1 / drag] at most: it damps speeds by exp(-1/16), which the method has to (1/16)^5 / 120 = 8e-9.
inline constexpr double damped_step = 0x1p-4;

/// Steps [1] of Newton's method to a contact within a step: a bound of the loop, for 6 double one digit to 53 bits.
inline constexpr int most_contact_steps = 8;
/// Gap [radius] of a contact that is closed there: what a place rounds to.
inline constexpr double closed_gap = unit_roundoff;

}  // namespace carom
