/// \file
/// The tolerances of the discrete methods: unit, value, reason.
#pragma once

#include <cstddef>
#include <cstdint>

namespace carom::stepping {

/// Remainder [steps] of until / dt that is no step of its own: rounding of dt and of the quotient, u each, for
/// up to 4e6 steps.
inline constexpr double step_remainder = 1e-9;
/// Number of steps [1] in place of all larger ones: 64 bits hold 9.2e18.
inline constexpr double most_steps = 9e18;

/// Looks [substeps] at clock and observer in small scenes are so far apart: they cost nothing then.
inline constexpr std::int64_t longest_watch_period = 64;
/// Spheres [1] whose substeps lie between two looks in large scenes, where a substep takes milliseconds.
inline constexpr std::int64_t spheres_between_looks = 4096;

/// Distance that a sphere may move in a pass of pbd until lists of those near it do not hold [deepest overlap]: 240
/// steps of settle_1000 take 0.45 s with these lists, 0.72 s without.
inline constexpr double list_reach = 2;

/// Product k |t| [1] beyond which (t - s) / k is taken as it stands: it loses less than two bits there, and up to it
/// the series of the exponential converges.
inline constexpr double large_damping = 1;
/// Drag times substep [1] at which semi-implicit Euler is no longer stable: it takes the part h k of a velocity, and 2
/// turns it round.
inline constexpr double unstable_damping = 2;

/// Halvings [1] of a substep in search of turns of a damped gap: two turns nearer than 2^-40 of it are a graze.
inline constexpr int most_turn_halvings = 40;

/// Change of a velocity in a sweep [largest velocity that was lacking] that ends a contact solver: some hundred units
/// in the last place, which sums of impulses leave.
inline constexpr double solved_contacts = 1e-13;

/// Substeps [1] that two bodies alone stay in contact under penalty without a stiffness, without damping: omega h =
/// pi/10. A fast impact is 3.2 v h deep. From the phase of the step in which the overlap is first seen the speed of
/// rebound is off by at most 0.2 % of the speed before at e = 1, 3.5 % at 0.8, 5.6 % at 0.5; with 20 steps by 0.02 %,
/// 1.7 %, 3.6 %, but then a ball dropped from 1 m sinks by 12 cm at 240 steps a second.
inline constexpr double steps_in_contact = 10;

/// Distance [smaller radius] up to which a path that passes by is a contact ahead: 4 slops of 5 mm for bodies 1 m wide
/// in Box2D, 2 cm in Jolt.
inline constexpr double speculative_margin = 0.04;
/// Share of an overlap [1] that speculative contacts part in a step: that of Box2D 2, Bullet and Jolt.
inline constexpr double overlap_recovery = 0.2;

/// Hertz of a soft contact [rate of the substeps] at most: Box2D 3.0 and 3.1.
inline constexpr double fastest_softness = 0.25;
/// Hertz of a soft contact with what does not move [those of others]: Box2D 3.
inline constexpr double static_stiffening = 2;
/// Speed at which a soft contact parts an overlap [smallest diameter times hertz] at most: 3 m/s for bodies 1 m wide at
/// 30 Hz in Box2D 3.
inline constexpr double push_out = 0.1;

/// Halvings [1] of a bracket: lo and hi are neighbours then, unless lo is many orders below hi.
inline constexpr int most_halvings = 64;
/// Height of a rebound [largest coordinate of the place] that is none: four roundings, of the three sums in n.p - d - r
/// and of p.
inline constexpr double rounding_of_place = 4 * 0x1p-52;
/// Gap [radii] at which a resting contact has opened: far above what a thousand steps add up to in rounding, 1e-13, and
/// far below what a sphere that has left rises in one, 1e-6 at least.
inline constexpr double open_contact = 1e-9;
/// Speed at which a resting contact opens [what gravity gives in a substep]: with it a sphere rises to a
/// millionth of the height that it falls in a substep.
inline constexpr double opening_share = 1e-3;
/// Sweeps [1] over resting contacts, at most: a column of 5 has its forces to 2.5e-4 then, as Gauss-Seidel carries a
/// force by one contact in a sweep, and to rounding after three substeps, which begin with the forces found.
inline constexpr int support_sweeps = 100;

/// Place [cells from the home of a grid] beyond which spheres are handled one by one: below it the rounding of position
/// / edge, two of u 2^30, stays under 2.4e-7 of a cell, less than `cell_slack`, and cell numbers fit 32 bits.
inline constexpr double farthest_cell = 1 << 30;
/// Edge of a cell beyond the largest diameter [1]: see `farthest_cell`.
inline constexpr double cell_slack = 1e-6;
/// Cells [1] of a grid at least: with an odd stride of 5 the 27 cells around one are still distinct.
inline constexpr std::uint32_t fewest_cells = 64;
/// Cells and spheres [1] of a grid at most: numbers of entries, which repeat some, fit 32 bits.
inline constexpr std::uint32_t most_cells = 1U << 30;
/// Cells for each sphere [1] of a grid at least: most are empty, so that a range seldom holds strangers.
inline constexpr std::uint32_t cells_a_sphere = 4;
/// Candidates [1] that are written at once, whatever their number: ranges are short and their lengths random, so loops
/// over them are mispredicted. 62 us became 40 us for 1000 spheres.
inline constexpr std::uint32_t gather_width = 4;
/// Ranges [1] that are gathered for a sphere: the rest of its own row and the four rows ahead.
inline constexpr std::size_t ranges_a_sphere = 5;
/// Candidates [1] that are tested in one loop: 4 KiB, which stay in the first cache.
inline constexpr std::size_t most_candidates = 512;

}  // namespace carom::stepping
