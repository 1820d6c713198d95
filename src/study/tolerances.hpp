/// \file
/// The tolerances of studies: what is compared, timed and said, with unit, value, reason.
#pragma once

#include <cstddef>
#include <limits>

namespace carom::study {

// Comparison with the reference.

/// Tolerance [m] by default of scenes in metres: a millimetre, which everybody can picture.
inline constexpr double pictured_tolerance = 1e-3;
/// Tolerance [smallest radius] below which a millimetre is too small to be asked for: steps would have to be tiny.
inline constexpr double least_pictured = 1e-4;
/// Tolerance [smallest radius] above which a millimetre is no precision: half of a sphere.
inline constexpr double most_pictured = 0.5;
/// Tolerance [smallest radius] by default of other scenes: what is seen on a page.
inline constexpr double default_tolerance_part = 0.01;
/// Distance [smallest radius] from the reference beyond which a run has diverged: an impact turns it into an angle of a
/// hundredth, and two or three impacts into other contacts.
inline constexpr double divergence = 0.01;
/// Distance [interval between samples] of a sample from an impact at which it falls on it: far above the rounding of
/// times, far below what a sample could otherwise show.
inline constexpr double on_impact = 1e-9;
/// Flight [interval between samples] of a bounce below which its impacts are not kept from samples: it changes nothing
/// that a figure shows.
inline constexpr double shortest_sampled_flight = 1e-6;
/// Samples [1] of the reference for each that is wanted, at most: one run of it then serves unless it ends in the first
/// sixteenth.
inline constexpr std::size_t most_spare_samples = 16;
/// States [1] of the reference in memory at most where more samples than wanted are taken: some 30 MB.
inline constexpr std::size_t most_reference_states = 400'000;
/// Times of one impact [steps] in two runs differ by at most this: methods with a step see it at the end of one.
inline constexpr double match_steps = 3;
/// The same without a step [time of the run], at least: far below the time between impacts, far above rounding.
inline constexpr double match_part_of_run = 1e-6;
/// Flight [steps] of a bounce below which no method with a step is asked for it. No derivation is known.
inline constexpr double shortest_flight_steps = 4;
/// Length of a series of bounces [1, part of it] that rounding may take from it; a body that breaks one off takes more.
inline constexpr double series_rounding = 1e-9;
/// Mismatches [impacts] that are gathered before they are sorted for the 200 that are listed: each is then sorted once
/// or twice.
inline constexpr std::size_t mismatches_between_sorts = 2000;

// The one-step audit.

/// Length [steps] of what a method is asked about: the step with the impact, and one more for methods that answer at
/// the beginning of the next.
inline constexpr int audited_steps = 2;
/// Length [steps] of the run of a case: some methods give the answer of the second step at the beginning of the third.
inline constexpr int longest_case = 3;
/// Distance [|dv| of the impact] from the true velocity within which a velocity is right: what nobody sees.
inline constexpr double right_velocity = 0.01;
/// Impacts [1] that are asked about at most, drawn at random: the 95 % interval of a share is then within 2.2 %.
inline constexpr std::size_t most_audited = 2000;
/// Quantile [standard deviations] of the normal distribution that leaves 2.5 % on each side: intervals of 95 %.
inline constexpr double two_sided_95 = 1.959963984540054;
/// Chance [1] that may lie beyond one end of an interval of 95 %.
inline constexpr double one_sided_95 = 0.025;
/// Questions [1] about the impacts of a scene at least, if it has any: each is asked about at several phases where
/// there are fewer, so that a share is known to 3 %.
inline constexpr std::size_t least_asked = 1000;
/// Steps without an impact [1] that are drawn for invented ones; not counted are those that turn out to have one.
inline constexpr std::size_t quiet_draws = 2000;
/// Flights [1] of the truth in memory at most: some 100 bytes each.
inline constexpr std::size_t most_truth_flights = 1'000'000;
/// Speed [largest speed of two that meet] that one of them may have after an elastic impact: its own and twice their
/// difference, which is at most twice that largest.
inline constexpr double elastic_gain = 5;
/// Neighbours of neighbours [links]: who may meet the bodies of a case, and who may meet those.
inline constexpr int neighbour_hops = 2;

// Steps that are enough.

/// Steps [1] through which an order is fitted at least: of two no scatter can be told.
inline constexpr std::size_t steps_of_a_fit = 3;
/// Factor [1] between the largest and the smallest step of a fit at least: of steps closer together only their scatter
/// shows.
inline constexpr double least_fitted_range = 2;
/// Order [1] below which errors no longer fall: ten times the steps leave two thirds of the error.
inline constexpr double stalled_order = 0.2;
/// Factor [1] above the smallest step in which errors must fall: of steps a factor of 4 apart it holds four, whose
/// order is known to 0.2 where each error is off by a factor of two.
inline constexpr double stall_span = 64;
/// Factor [1] between the largest and the smallest step tried from which on a search may end because errors stall:
/// those of chaotic runs are as large as the scene until steps are small.
inline constexpr double least_range_tried = 4096;
/// Steps [1] of the grid of a search in each factor of two: close to its answer scans of 64 and 128 differ by up to
/// 7 %, for one of ten methods 30 %, scans of 16 by up to 50 %.
inline constexpr int search_grid = 128;
/// Factor [1] below the first step that fails in which all steps of the grid are tried: of errors that scatter about
/// first order most of those above the tolerance are there.
inline constexpr double edge_range = 1.5;
/// Steps [1] in each factor of two that are tried below that: errors there must be of a rare size to matter.
inline constexpr int search_density = 32;
/// Factors of two [1] from step to step while the search looks for one that holds, or for one that does not.
inline constexpr int search_stride = 2;
/// Factor [1] below the answer down to which steps are tried: errors of first order that scatter by less than this are
/// then within the tolerance below it, too.
inline constexpr double scanned_range = 4;
/// Runs [1] for one method at most: several times those of a scan that finds a failing step at each density.
inline constexpr std::size_t most_tries = 1000;
/// Time [s] for the runs of one method: a step that takes longer is no answer to a question about cost.
inline constexpr double search_budget = 10;
/// Step [longest step asked for] up to which larger ones are tried.
inline constexpr double largest_searched = 16;
/// Steps [1] of a run at least: with fewer, steps are no steps.
inline constexpr double fewest_searched_steps = 8;

// Clocks.

/// Time [s] of a tick of the clock's second number.
inline constexpr double nanosecond = 1e-9;
/// Time [s] that runs fill together: a thousand times the cost of reading the clock.
inline constexpr double resolved_by_clock = 2e-3;
/// Runs [1] in a row at most: even one of a microsecond then fills half of `resolved_by_clock`.
inline constexpr double most_runs_in_a_row = 1000;
/// Repeats [runs] of a timing by default: the median of three leaves one disturbance out.
inline constexpr int timing_repeats = 3;
/// Spread [median] of the median of repeats, its interval of 95 %, at which timing ends: a ratio is then known to a
/// tenth.
inline constexpr double timing_spread = 0.05;
/// Repeats [runs] of a timing at most: the median's interval no longer shrinks much.
inline constexpr int most_timings = 30;
/// Repeats [runs] from which on the least and the greatest are not the ends of the interval of 95 %: 2^(1-6) is 3 %.
inline constexpr std::size_t fewest_for_interval = 6;
/// Time [s] for all repeats together: nobody waits longer for a row.
inline constexpr double timing_budget = 5;
/// Work of the event method [steps], a guess for the progress line only.
inline constexpr double event_run_in_steps = 1000;
/// Spheres [1] up to which looking at all of them costs less than stopping the clock for it.
inline constexpr std::size_t few_to_look_at = 30;
/// Spheres [1] that an event-driven run is looked at, all looks together: at 700 instructions each they cost half as
/// much as one second of gas_1000.
inline constexpr std::size_t most_spheres_looked_at = 25'000;
/// Intervals [1] between looks at least, where those are not even one look: a run is looked at when it begins, in its
/// middle and at its end.
inline constexpr std::size_t fewest_looks = 2;

// Words.

/// Per cent [1] in a whole: that is what the word means.
inline constexpr double per_cent = 100;

/// Factor [1] between two steps up to which a linear range between them is advised, beyond it a logarithmic one.
inline constexpr double linear_range_factor = 2;
/// Factor [1] between two steps that is an answer: nobody needs a step to more than a tenth.
inline constexpr double fine_bracket = 1.1;
/// Digits [1] of a time in a sentence: more are noise there.
inline constexpr int time_digits = 5;
/// Digits [1] of a step that is no fraction and no short decimal: more are noise there.
inline constexpr int step_digits = 4;
/// Denominator [1] of a fraction that is written as one: more digits are no shorter.
inline constexpr double largest_denominator = 1e9;
/// Distance [1, part of it] of a step from a fraction that it is: ranges miss 1/n by a rounding or two.
inline constexpr double same_step = 1e-12;
/// Length [m] below which no prefix helps: a nanometre is the smallest that is named.
inline constexpr double smallest_named_length = 1e-9;
/// Length [m] from which on metres are written.
inline constexpr double metres_from = 1;

// Repeated runs (repeat_run.cpp).

/// Distance [largest coordinate] within which two places that are written as doubles are one: an ulp at most.
inline constexpr double spacing_of_doubles = std::numeric_limits<double>::epsilon();

// Stress cases (stress.cpp).

/// Time [s] after which a run of a stress case is given up that is discrete, or that waits for what is not built: those
/// that end take half of it at most.
inline constexpr double longest_stress_run = 20;
/// Overlap [smallest radius] that counts as having sunk: half of a sphere is inside another one.
inline constexpr double sunk = 0.5;
/// Change [largest kinetic energy] of energy that counts as not kept: it is seen on a plot.
inline constexpr double much_energy = 0.01;

// Verdicts.

/// Bodies [1] that a sentence names, with their velocities: more are no sentence.
inline constexpr std::size_t most_bodies_in_words = 3;

}  // namespace carom::study
