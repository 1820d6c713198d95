/// \file
/// The tolerances of broad phases: unit, value, reason.
#pragma once

#include <cstddef>

namespace carom {

/// Parts [1] of a power of two to which a cell size is rounded up: its mantissa has four bits, so that its multiples up
/// to 2^49, the walls, are exact doubles.
inline constexpr double cell_size_parts = 8;
/// Cell size [mean spacing] where spheres are sparse: about one sphere in five cells. Measured on gas_1000: 0.4, 0.6, 1
/// and 1.3 spacings cost 503, 489, 742 and 1107 million instructions.
inline constexpr double spacings_a_cell = 0.6;

/// Fewest cells of the table along an axis [bits]: 4, so that the 27 around a body are 27 entries.
inline constexpr int least_bits_an_axis = 2;
/// Most cells of the table along an axis [bits]. No derivation: with `entry_bits_a_sphere` it binds only where more
/// than 2^21 spheres stand in a row.
inline constexpr int most_bits_an_axis = 20;
/// Entries of the table for each sphere [bits]: 8. No derivation, and not measured.
inline constexpr int entry_bits_a_sphere = 3;

/// Distance [cells] that a body may be off its cell before it is filed anew. Rounding of a place, u of a cell, is far
/// below it; two bodies come nearer by 2 of it, 0.2 % of a cell, than their cells say, which `reach_slack` covers.
inline constexpr double cell_slack = 0x1p-10;

// Lists of neighbours.

/// Part of the escape radius [1] that is left for rounding: places within 2^30 of a radius round by 2^-22 of it.
inline constexpr double shell_slack = 0x1p-10;
/// Neighbours of a body [1] for which there is room at first: with those of a dense fluid, 13 on the mean, it seldom
/// has to grow.
inline constexpr std::size_t first_room = 24;

}  // namespace carom
