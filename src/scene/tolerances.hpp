/// \file
/// The tolerances of scenes, their fills and their checks: unit, value, reason.
#pragma once

#include "math/error_free.hpp"
#include "projection/tolerances.hpp"

#include <cstddef>

namespace carom {

// Contacts.

/// Gap [radius of the smaller body] within which bodies touch: a contact that a scene declares, no overlap, and the
/// gap_tolerance of rest. Far above the rounding of a place, 1e-15 of the coordinates, and far below anything seen.
inline constexpr double declared_contact = 1e-9;
/// Squared distance [length^2] above which the root is that of the sum of squares: smaller ones may have lost some to
/// underflow.
inline constexpr double smallest_plain_square = 1e-280;
/// Squared distance [length^2] below which no square overflowed.
inline constexpr double largest_plain_square = 1e280;

// Defaults of rest, v_c the closing speed (carom::rest_thresholds; docs/regimes.md measures what they cost).

/// Height [smallest radius] to which a sphere at v_c rises: a bounce that nobody sees.
inline constexpr double closing_height = 1e-5;
/// v_c without gravity [root mean square of the speeds at the start]. No derivation is known.
inline constexpr double closing_speed_part = 1e-6;
/// Window without gravity [time in which a body of that speed goes a smallest radius]: at v_c it goes 1e-12 of it.
inline constexpr double window_part = 1e-6;
/// Numeric steps [1] in the time in which a body falls half its radius, or goes its radius where there is no gravity:
/// docs/regimes.md, "slides off a sphere", has the errors of 25, 50 and 100.
inline constexpr double numeric_steps_a_radius = 50;

// Validation.

/// Error [1] of the square of a normal's length: rounding leaves 4e-16; a normal needs twelve digits.
inline constexpr double unit_square_error = 1e-12;
/// Gap [smallest radius] that thresholds may take for a contact at most: contacts that are open are not closed.
inline constexpr double largest_contact_gap = 1e-2;
/// Sine [1] of the angle of two planes up to which they are parallel but for rounding of normals, at most 4 u.
inline constexpr double parallel_rounding = 1e-15;
/// Sine [1] of the angle of two planes that are no wedge below it: ten times what makes normals depend on each other.
inline constexpr double narrowest_wedge = 10 * dependent_normal;

/// Overlaps [lines] that are named; the others are counted.
inline constexpr std::size_t most_overlaps_named = 20;
/// Overlaps [pairs] that are counted: a pile at one point would have N^2/2 of them.
inline constexpr std::size_t most_overlaps_counted = 10'000;
/// Depth in a message [depth that was found], which is to four digits: rounded up, so that the cure cures.
inline constexpr double overlap_rounded_up = 1.001;

// Choice of the broad phase.

/// Spheres [1] up to which all pairs cost less than a grid (tests/bench/event_run.cpp, and by the same count for the
/// discrete methods).
inline constexpr std::size_t all_pairs_limit = 32;
/// Volume of a sphere [cube of its radius]: 4 pi / 3, of which only a choice depends.
inline constexpr double sphere_volume = 4.18879020478639;
/// Ratio [1] of the largest radius to the smallest up to which spheres are alike: the cells from which lists are made
/// are as large as the largest needs.
inline constexpr double alike_radii = 2;
/// Packing fraction [1] from which on lists cost less than cells.
inline constexpr double least_fraction_for_lists = 0.02;

// Grid of spheres at the start.

/// Reach [1] beyond the sum of two radii at which spheres are looked for: it covers the rounding of cell numbers, u of
/// the coordinate over a diameter, up to 1e9 diameters from the origin.
inline constexpr double grid_slack = 1e-6;
/// Cell number [cells] of all that are farther out, and of what is no number: slow there, but right, and no integer
/// overflows.
inline constexpr double farthest_cell_number = 0x1p60;
/// Cells in a length [1/length] at most: the inverse of a smaller radius is out of the range of doubles, and larger
/// cells do as well.
inline constexpr double most_cells_per_length = 1e300;
/// Places [1] of a grid's table at least: fewer save nothing.
inline constexpr std::size_t fewest_buckets = 64;

// Fills.

/// Packing fraction [1], volume of the spheres over that of the region, that random insertion is asked for at most. It
/// jams at 0.38.
inline constexpr double largest_random_fraction = 0.30;
/// Error [1, of itself] of the packing fraction of one sphere: 5 roundings of a volume, 9 of the cube of a radius that
/// is itself right to an ulp, 6 of the region's volume and the quotient, 1 of the limit; 21 counted, less the one of a
/// sum that one sphere does not have.
inline constexpr double fraction_rounding = 20 * unit_roundoff;
/// Error [1, of the sum] that each further sphere adds to a packing fraction.
inline constexpr double term_rounding = unit_roundoff;
/// Gap [radius] that random insertion leaves at least: a thousand times what would pass for a declared contact.
inline constexpr double least_random_gap = 1e-6;
/// Tries [1] for one sphere of a random fill: where a tenth of a percent of the places are free, all miss with e^-1000.
inline constexpr std::size_t most_random_tries = 1'000'000;
/// Tries for each sphere [1] of a random fill on average: at the largest fraction it takes 200.
inline constexpr std::size_t most_mean_random_tries = 2'000;
/// Tries [1] granted to every random fill, beside the mean: a few spheres may be hard to place.
inline constexpr std::size_t first_random_tries = 10'000'000;
/// Spacing [largest spacing] of a cubic lattice from which on an axis ties with the widest: quotients that are equal on
/// paper differ by u.
inline constexpr double cubic_tie = 1 - 1e-12;

}  // namespace carom
