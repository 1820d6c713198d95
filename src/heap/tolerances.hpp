/// \file
/// The tolerances of windows of heaps: unit, value, reason.
#pragma once

#include <cstddef>

namespace carom {

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
