/// \file
/// The tolerances and limits of event-driven runs: unit, value, reason.
#pragma once

#include "flight/tolerances.hpp"
#include "motion/tolerances.hpp"
#include "toi/tolerances.hpp"

#include <cstdint>

namespace carom {

// Range of scenes (range.cpp).

/// Largest length, mass, speed and acceleration [unit]: squares reach 2^800, and products of a few are doubles. No
/// exact derivation: a mass times such a square, 2^1200, is none.
inline constexpr double largest_size = 0x1p400;
/// Smallest radius and mass [unit]: likewise.
inline constexpr double smallest_size = 0x1p-400;
/// Weakest gravity but none [length/time^2]: 2^22 above the least normal number, so that 1e-9 of it, which solvers
/// divide by, keeps digits.
inline constexpr double weakest_gravity = 0x1p-1000;
/// Longest time [time]: its product with a speed is looked at by itself, see `longest_flight`.
inline constexpr double longest_run = 0x1p800;
/// Longest flight [length]: what times of impact take.
inline constexpr double longest_flight = largest_number;
/// Largest place and time [cells, epochs] of a scene: a quarter of what is counted, so that sums of a few fit, too.
inline constexpr double furthest_in_scenes = furthest / 4;

/// Distance [smallest radius] of spheres from the first one up to which lists of neighbours are used: `shell_slack` has
/// room for its rounding.
inline constexpr double furthest_in_lists = 0x1p30;

// Impacts.

/// First nudge [speeds] of a contact that still closes after its impact: the rounding of its speed.
inline constexpr double first_nudge = normal_speed_rounding;
/// Nudges [1], each twice the last: 51 reach the speed itself.
inline constexpr int most_nudges = 64;
/// Change of speed [that of the impulse that an event is about] which balances it and is named. No derivation.
inline constexpr double balancing_part = 1e-3;

// Limits of a run.

/// Seconds [s] from which on there is no deadline: 30 years, and clocks of nanoseconds in 64 bits end at 9.2e9.
inline constexpr double longest_deadline = 1e9;
/// Events [1] between two looks at the clock and at the observer: a look takes 20 ns, 256 events 0.1 ms.
inline constexpr std::int64_t look_every = 256;

}  // namespace carom
