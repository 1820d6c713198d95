/// \file
/// The tolerances of the geometry that a certificate states: unit, value, reason. Lengths are cells of the run, times
/// its epochs. What the audits of dynamics allow stands beside them.
#pragma once

#include "math/tolerances.hpp"

#include <carom/types.hpp>

#include <cstddef>
#include <cstdint>

namespace carom::verification {

// Roundings.

/// u [1], in which roundings are counted: half an ulp of 1.
inline constexpr double u = unit_roundoff;
/// Error of a place, a speed, or a product of two of them in double [sizes of its parts]: a place is cells + local +
/// tau (v + tau a/2), ten roundings, and one more where low parts are dropped.
inline constexpr double double_rounding = 16 * u;
/// The same in double-double [sizes of its parts]: ten operations of 5 u^2 at most (math/double_double.hpp).
inline constexpr double double_double_rounding = 96 * u * u;
/// Error of a duration in double [1]: sum and difference, 2 counted, and what is multiplied by it.
inline constexpr double duration_rounding = 8 * u;
/// The same where nothing is left of epochs [epochs]: 1 for each of two offsets.
inline constexpr double offsets_rounding = 4 * u;
/// Error of a duration since a reference [duration, and an epoch more]: two differences of offsets, 4 counted.
inline constexpr double reference_rounding = 8 * u;
/// Error of a vector that is split along a normal [its size]: n.v 3, n.n 3, quotient and product 1 each, 8 counted,
/// here and where it was recorded.
inline constexpr double split_rounding = 16 * u;
/// Error of a place below 0 that is recorded in its cell [cells]: ulps of places just below a whole number of cells are
/// u, 1/2 counted.
inline constexpr double negative_place_rounding = 2 * u;
/// Size [1] that is kept as a float: rounded up, of which u is 6e-8.
inline constexpr double float_rounded_up = 1.0001;

// Drag (drag.cpp). Errors as counted in drag.hpp are below `double_double_rounding` of sizes, sums included.

/// Factor [1] n of z/n with which the series ends: 2 / 31! = 2^-112 is left out where z <= 1.
inline constexpr int damped_terms = 31;
/// The same [1] for short times: (1/64)^13 2 / 15! = 2^-117.
inline constexpr int short_damped_terms = 15;
/// Time k t [1] up to which the short series will do.
inline constexpr double short_series_up_to = 0x1p-6;
/// Time k t [1] from which on nothing is left of a speed: exp(-80) is 2^-115.
inline constexpr double longest_decay = 80;

// First look at pairs and planes (quick_look.hpp).

/// Error of straight paths from a reference [sizes of their parts]: `double_rounding`, and 2 for the reference.
inline constexpr double quick_rounding = 20 * u;
/// Error of the least |r|^2 - S^2 [squares of the sizes]: some 12 counted.
inline constexpr double quick_square_rounding = 32 * u;
/// Error of a height above a plane [sizes of its parts]: `double_rounding` for the path, some 10 for the height.
inline constexpr double quick_height_rounding = 64 * u;
/// Height of an arc over its chord [a t^2]: 1/8, and 4 % for rounding. No derivation of these.
inline constexpr double quick_arc = 0.13;

// Least gaps (pair_gap.cpp, pair_gap_accelerated.cpp, plane_gap.cpp).

/// Error of the value at a vertex [that value]: rounding to a double and the quotient 1 each, 2 counted.
inline constexpr double vertex_rounding = 4 * u;
/// Error of the value of a tangent [that value]: 5 counted. Where it cancels they are roundings of |r|^2 - S^2, whose
/// bound has room for them.
inline constexpr double tangent_rounding = 8 * u;
/// Roundings of h - w^2/(2 g) [double_rounding or double_double_rounding of w^2/(2 g)]: square, product, quotient and
/// difference 1 each, 4 counted.
inline constexpr double drop_roundings = 8;
/// Height of an arc over its chord [g t^2/8] that is an upper bound: 1 % covers rounding. No derivation.
inline constexpr double arc_rounded_up = 1.01;
/// Intervals [1] into which the quartic of a pair is cut at most; beyond them nothing is stated. No derivation.
inline constexpr int most_intervals = 400;
/// Halvings [1] of such an interval: 53 exhaust a duration, and where it begins at 0 a few more.
inline constexpr int most_interval_halvings = 60;
/// Error of F''/2 and of its change [sizes of their parts]: roundings, 1e-15, with any room; it costs cuts at most.
inline constexpr double curvature_slack = 1e-12;
/// Length of an interval [1]: the difference of two doubles, u of the later one, with any room.
inline constexpr double interval_rounded_up = 1 + 1e-12;
/// Change of F''/2 over an interval [1]: 1 % covers the roundings of the sum that bounds it. No derivation.
inline constexpr double change_rounded_up = 1.01;

// Exact numbers (exact.hpp).

/// Size [1] below which a product of doubles may underflow, with its rounding error, 2^-53 of it: far above 2^-1022.
inline constexpr double smallest_exact_product = 0x1p-900;
/// Size [1] above which a product may overflow in the splitting of its factors. Any number far below 2^1024 would do.
inline constexpr double largest_exact_product = 0x1p900;
/// Parts [1] of an exact number: 80 of 53 bits each span the 4,200 bits of products of doubles, the rest is room.
inline constexpr std::size_t most_exact_parts = 100;

// Gaps and contacts (gaps.hpp).

/// Gap that may be missing [sum of the radii, or what was flown]: the promise for runs in doubles, 16 eps.
inline constexpr double promised = 16 * 2 * u;
/// Gap [smaller radius] by which a persistent contact may be off: the promise of the engine, `declared_contact` of
/// scenes.
inline constexpr double contact_slack = 1e-9;
/// Deepest overlap [smaller radius] of numeric pieces, whose paths are known roughly. No derivation: 1e-6 is expected
/// (docs/regimes.md, "rolling").
inline constexpr double deepest_numeric = 1e-2;
/// Deepest overlap [smaller radius] of what no closed form gives, under the guard: beyond it, it is no error of a step
/// any more. No derivation.
inline constexpr double deepest_guarded = 0.5;
/// Change of a gap [radius] that does not deepen an overlap. No derivation: a gap at the start of a flight is known
/// better.
inline constexpr double deepening = 64 * u;

/// Speed [v_c] that may be taken from bodies that contacts hold together. No derivation: with the default of v_c a body
/// rises 1e-17 of a radius with it.
inline constexpr double still = 1e-6;
/// The same [speeds of the others]: what an impact of several contacts leaves of theirs. No derivation.
inline constexpr double hidden = 1e-12;

// Support (coverage.cpp, cone.cpp).

/// Push [gravity] that needs no contact. No derivation: accelerations of up to 4e-9 of gravity are taken for 0
/// (docs/regimes.md).
inline constexpr double no_push = 1e-8;
/// Error of a distance [sizes of the places]: four times `double_rounding`.
inline constexpr double touch_rounding = 64 * u;
/// Angle [1] by which a numeric partner may have turned the normal of a contact while a body stayed at rest on it: that
/// body finds out at the end of the step. From rest, g h^2 / 2 in a step of h = sqrt(r/g) / 50, over 2 r; one that has
/// been on its way turns it by |w| h / (r_a + r_b) more.
inline constexpr double turned_in_a_step = 1e-4;
/// Normals [1] of which all sets of three are tried, those that point most along the push: 17,296 sets. A sphere
/// touches 12 of its size.
inline constexpr std::size_t most_normals = 48;
/// Error of a normal [1], which multiplies pushes of jammed bodies: a separation, `double_rounding` of its size.
inline constexpr double normal_rounding = 16 * u;
/// Sum of pushes [the push that they balance] beyond which any direction is as good as another. No derivation: with
/// `normal_rounding` it is off by 2e-6.
inline constexpr double largest_multiple = 1e9;

// Neighbours in cells (cells.cpp). Only time depends on these, but for `most_cell_number`.

/// Levels [1] of sizes of cells; should there be more, neighbours share one. A level is kept in a byte, below 256.
inline constexpr std::size_t most_levels = 200;
/// Cells [1] that a sphere may sweep and is still listed in each: 3 along each axis.
inline constexpr double most_cells = 27;
/// Entries [spheres] for which there is room at once: growing would take twice that. No derivation, and not measured.
inline constexpr std::size_t usual_entries = 5;
/// Number of a cell [cells] beyond which everybody is looked at: below it sums of a few are whole numbers exactly.
inline constexpr double most_cell_number = 0x1p50;

// Slabs of time (coverage.cpp, coverage_slabs.cpp). Only time depends on these, but for `arc_over_chord`.

/// Spheres [1] up to which all pairs cost less than looking for neighbours. Not measured since.
inline constexpr BodyId all_pairs_up_to = 40;
/// Height of an arc over its chord [a t^2]: 1/8, and 0.8 % for rounding. No derivation of these.
inline constexpr double arc_over_chord = 0.126;
/// Flights [for each sphere] begun since the reference of quick looks: what is straight on from an old one loses
/// precision. No derivation.
inline constexpr std::size_t flights_a_reference = 8;
/// Exponent [bits] of the longest slab, and minus that of the shortest: 2^40 epochs, as far as doubles tell them apart.
inline constexpr int slab_bits = 40;
/// Shortest slab [epochs]: see `slab_bits`; offsets, known to u, tell it from 0.
inline constexpr double shortest_slab = 0x1p-40;
/// Longest slab [epochs]: see `slab_bits`, it is that power.
inline constexpr double longest_slab = 0x1p40;
/// Slabs [1] after which bodies are sorted by place again: they stray from their neighbours. No derivation.
inline constexpr std::int64_t slabs_a_sorting = 16;
/// New entries in cells [for each sphere] after which a slab has been long enough. No derivation.
inline constexpr double most_new_entries = 2;
/// Cells swept [for each sphere] below which the next slab is twice as long: most sweep one. No derivation.
inline constexpr double few_cells_swept = 1.5;
/// Cells swept [for each sphere] above which the next slab is half as long. No derivation.
inline constexpr double many_cells_swept = 3;
/// Slabs [1], beside one for each flight, after which they only grow: absurd speeds must not make it endless. No
/// derivation.
inline constexpr std::int64_t most_slabs = 20'000;

// Numbers as read (flight_audit.cpp, verify.cpp).

/// Place or time [cells, epochs] of a record: whole numbers below it, and their sums, are exact as doubles.
inline constexpr double most_recorded = 0x1p52;
/// Work of an instant [pair tests, see Patience]: an estimate of that of a small one, large ones ask on their way.
inline constexpr std::size_t instant_work = 64;
/// Flights [1] of an instant among which a body is looked for one by one: quicker than in a set. Not measured.
inline constexpr std::size_t few_flights = 8;

}  // namespace carom::verification
