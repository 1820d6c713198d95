/// \file
/// The tolerances of windows: unit, value, reason. Measured values are those of carom_heap_bench.
#pragma once

namespace carom {

// Windows (window.cpp).

/// Overlap [smaller radius] that counts as none: the rounding of places a thousand radii from the origin of their
/// coordinates, and of the projection that an exact window leaves, 1e-12 of the way of free fall.
inline constexpr double overlap_of_rounding = 1e-11;
/// Gap [smaller radius] at which exact windows stop contacts that close, more than their solver misses:
/// `interior_accuracy` of a fall of `descent_of_fall` radii.
inline constexpr double exact_margin = 1e-10;
/// Gain of energy [sum of m |a| r over the bodies] that counts as none: what ten layers gain where each contact is
/// missed by `exact_margin`. Measured over whole runs: 3e-15 of the energy at the start.
inline constexpr double energy_of_rounding = 1e-9;
/// Gap [smaller radius] within which a contact takes part in an exact window at any speed: what calm heaps go in one.
inline constexpr double exact_reach = 0.1;
/// Ways [1] that the velocity at the start would make, within which a contact takes part in an exact window.
inline constexpr double exact_reach_of_speed = 2;
/// Part [1] of what a gap misses of the margin that one window makes good. Smaller parts lift a heap more softly and
/// leave gaps longer to the errors of relaxation.
inline constexpr double margin_made_good = 0.2;
/// Part [1] of the way to the first overlap that a window which ends early goes.
inline constexpr double part_of_the_way = 0.9;
/// Part [1] of a window below which the next solver is asked rather than the window shortened.
inline constexpr double least_part = 0.2;
/// Part [1] of an exact window below which it is given up: then a thousand windows would take the time of one.
inline constexpr double least_part_of_all = 1e-3;
/// Free fall [ways of free fall in the window] beyond its own motion from which a contact takes part: what pushes a
/// body in the window makes that of it at most, most often. What it misses is found afterwards.
inline constexpr double reach_of_fall = 4;
/// Margins [1] within which a contact takes part at any speed.
inline constexpr double reach_of_margin = 4;
/// Sweeps [1] of relaxation in a window, over the contacts that are still wrong.
inline constexpr int most_window_sweeps = 400;
/// Solutions [1] of one window in which contacts that were left out are found: each adds one at least, most often
/// all.
inline constexpr int most_added_rounds = 40;

// Relaxation (relaxation.cpp).

/// Sweeps [1] of the first round, before it is asked again which contacts are wrong.
inline constexpr int first_round_of_sweeps = 6;
/// Sweeps [1] by which rounds grow: what is left converges more slowly.
inline constexpr int round_growth = 2;

// Restitution (restitution.cpp).

/// Sweeps [1] from the fast contacts outwards: ten layers of a heap.
inline constexpr int rebound_sweeps = 10;
/// Rate [closing speeds] that rebounds leave: a tenth of what counts as fast.
inline constexpr double rebound_tolerance = 0.1;

// Landing (landing.cpp, statics.cpp).

/// Gap [smallest radius] of contacts that carry at rest: rounding of places some thousand radii from the origin.
inline constexpr double gap_at_rest = 1e-12;
/// Acceleration [that of the fall] of a body at rest: half of what a body's contacts may leave where the engine asks
/// for balance (docs/regimes.md).
inline constexpr double acceleration_at_rest = 4e-9;
/// Gap [smaller radius] that the descent leaves at contacts, ten times `exact_margin`: Newton's method closes it.
inline constexpr double landing_margin = 1e-9;
/// Way [smallest radius] of free fall in one step of the descent: far beyond what a calm heap goes, so that the step is
/// that of the linear program of lowest height but for free directions.
inline constexpr double descent_of_fall = 16;
/// Factor [1] of the fall after a step that would overlap.
inline constexpr double shorter_fall = 1.0 / 16;
/// Fall [smallest radius] below which no step is tried: a hundred times `newton_converges`.
inline constexpr double least_descent_of_fall = 1e-2;
/// Way [smallest radius] of a step below which Newton's method takes over: what it leaves, the square, is below 1e-8.
inline constexpr double newton_converges = 1e-4;
/// Steps [1] of the descent, each an interior point solve: near a corner they converge as squares.
inline constexpr int most_descents = 16;
/// Steps [1] of the descent after which it must have become slower: those that end at rest become slower three times
/// and more in each step or two, those of a heap that goes on to collapse keep their size for ten and more (measured
/// with 300 and 1,000 balls).
inline constexpr int steps_to_converge = 2;
/// Way [root mean square of the first step] that a step may then have.
inline constexpr double landing_converges = 0.5;
/// Bodies [1] that may go on longer: the steps of small heaps are cheap.
inline constexpr int patient_landing = 100;
/// Times [1] that bodies are left out and the descent begins anew: where more must be, all lean on each other (measured
/// with 300 and 1,000 balls: four rounds leave less than half).
inline constexpr int most_left_out = 1;
/// Part [1] of the bodies that must rest for a landing to be worth it.
inline constexpr double least_resting = 0.5;
/// Force [largest] below which a contact carries nothing: rounding of the forces of badly shaped heaps.
inline constexpr double least_force = 1e-12;
/// Steps [1] of Newton's method and of contacts that leave it: 3 to 5 are measured.
inline constexpr int most_newton_steps_of_landing = 60;
/// Part [1] by which the diagonal of the products of normals grows, so that dependent normals share a force.
inline constexpr double statics_regularisation = 1e-13;
/// Rounds [1] of refinement against the products themselves.
inline constexpr int statics_refinements = 2;

// Interior points (interior_point.cpp).

/// Least slack [scale] at the start, far from its bound: no solve for a better one is worth its factor, since changes
/// are of the size of the scale.
inline constexpr double first_slack = 0.1;
/// Multipliers [scale] at the start: of the size of changes, far from 0, for the same reason.
inline constexpr double first_multiplier = 0.5;
/// Part [1] of the step to the nearest bound.
inline constexpr double interior_step = 0.995;
/// Mean product of slack and multiplier [scale^2] at the end.
inline constexpr double interior_complementarity = 1e-13;
/// Slack [scale] that differs from that of the point at the end.
inline constexpr double interior_miss = 1e-10;
/// Slack [scale] that is violated, or that a multiplier bears, in a complete result.
inline constexpr double interior_accuracy = 1e-11;
/// Weight [1] of slacks while multipliers are polished: it magnifies the rounding of slacks to 1e-12 of the scale, and
/// each round leaves 1 / (1 + weight sigma^2) of what it mends, sigma the singular values of the unit normals.
inline constexpr double polishing_weight = 1e4;
/// Rounds [1] of polishing, a solve each: eight decades where sigma^2 is 1e-3.
inline constexpr int most_polishing_rounds = 8;
/// Slack [scale] that polishing need not mend.
inline constexpr double polished_enough = 1e-14;
/// Errors [the least so far] beyond which rounding makes steps worse.
inline constexpr double interior_diverges = 1e6;
/// Largest ratio [1] of a multiplier to its slack: factors know the unit matrix beside it to a hundredth.
inline constexpr double largest_stiffness = 1e13;
/// Steps [1] in a row that improve nothing and are granted all the same: a centring step or two may.
inline constexpr int most_stalls = 2;
/// Multiplier [its slack] below which a half-space bounds nothing: without it the point goes less than that part of the
/// slack.
inline constexpr double negligible_multiplier = 1e-3;
/// Steps [1] granted: 12 to 25 are measured.
inline constexpr int most_interior_steps = 60;

}  // namespace carom
