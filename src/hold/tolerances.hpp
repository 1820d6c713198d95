/// \file
/// The tolerances of contacts that persist: unit, value, reason.
#pragma once

#include "motion/tolerances.hpp"

#include <cstddef>

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

// Windows of heaps.

/// Length of a hot window [numeric_step]: a thirty-second of sqrt(r / g), in which a heap falls 5e-4 of a radius.
inline constexpr double window_steps = 50.0 / 32;
/// Skin [smallest radius] of a list of pairs at least. No derivation.
inline constexpr double least_skin = 0.35;
/// Skin [ways of the fastest in a hot window] at least: then a list lasts for three of them.
inline constexpr double ways_in_skin = 6;
/// Skin [largest radius] up to which a block of 5^3 cells shows every pair: cells are a largest diameter wide at least.
inline constexpr double widest_skin_of_grid = 1.9;
/// Free fall [ways of free fall in the window] by which others may push a body beyond its own motion, as
/// `reach_of_fall`.
inline constexpr double fall_of_others = 4;
/// Change of speed [that of free fall in the window] that relaxation leaves.
inline constexpr double speed_left = 0.1;
/// Margin [smallest radius] of hot windows: twice the way of free fall in one.
inline constexpr double margin_of_radius = 1e-3;
/// Speed [calm speed] of the fastest from which on the margin has its full size; as a heap calms it shrinks.
inline constexpr double margin_speed = 0.6;
/// Margin [margin_of_radius] of slow heaps. No derivation.
inline constexpr double least_margin = 0.3;
/// Rise [smallest radius] with the calm speed: what lists and landings have room for, a tenth of it.
inline constexpr double calm_rise = 0.04;
/// Speed [calm speed] below which the length of a window does not ask for it: any small number would do.
inline constexpr double least_calm_part = 1e-9;
/// Way [smallest radius] of the fastest in a calm window, a third of its skin.
inline constexpr double calm_way = 0.3;
/// Length [hot windows] of a calm window at least: one costs as much as some hot ones.
inline constexpr double shortest_calm = 4;
/// Length [hot windows] of a calm window at most: 0.06 s at a radius of 8 mm. Longer ones are cheaper, but what
/// collapses slowly goes on for as many windows, however long they are: with twice the length two of five heaps of 300
/// do not rest by 3 s.
inline constexpr double longest_calm = 64;
/// Length [hot windows] of such a window of up to `quick_landing` bodies at most, which land sooner.
inline constexpr double longest_calm_of_few = 128;
/// Way [smallest radius] that a body may go to its rest.
inline constexpr double landing_way = 0.3;
/// Skin [smallest radius] of lists of calm heaps: more than two of these ways.
inline constexpr double calm_skin = 1;
/// Speed [calm speed] of the moves of a landing.
inline constexpr double landing_speed = 1;
/// Bodies [1] of which each calm window is followed by an attempt to land: one is cheap.
inline constexpr std::size_t quick_landing = 100;
/// Time [hot windows] that more wait after an attempt that failed, half of the second: one of the longest calm windows.
/// No derivation.
inline constexpr double first_wait_between_landings = 64;
/// Time [hot windows] that they wait at most: some of the longest calm windows, each as dear as a step of a landing.
inline constexpr double longest_wait_between_landings = 1024;
/// Part [1] of the speed at an attempt that failed at which they wait no longer: heaps that come to rest become slower
/// by more in two windows, heaps that collapse do not in ten.
inline constexpr double slower_than_failed = 0.25;
/// Time [hot windows] that attempts to land wait after a heap was woken, half of the first. No derivation.
inline constexpr double first_wait_after_waking = 8;
/// Time [hot windows] that they wait at most. No derivation.
inline constexpr double longest_wait_after_waking = 256;
/// Length [that of the last try] of a window after one that cannot be had.
inline constexpr double shorter_window = 0.25;
/// Shorter windows [1] that are tried before all bodies are stopped for one: 4^-20 of a window.
inline constexpr int most_shorter_windows = 20;
/// Way [room in a list] of a window that is shortened to it: less than 1 by far more than rounding.
inline constexpr double part_of_the_room = 0.9;
/// Length [window] below which a new list is made rather than the window shortened. No derivation.
inline constexpr double least_part_of_list = 0.2;

}  // namespace carom
