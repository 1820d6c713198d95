/// \file
/// The tolerances and limits of the study of tunnelling: unit, value, reason.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace carom::tunnel {

/// Distance [smaller of radius and reach] at the throw's speed within which an exact method finds the time of a
/// contact, as the one-step audit of `compare` asks it: far above rounding.
inline constexpr double exact_time = 1e-9;
/// Distance [|dv| of the contact] of the velocity that an exact method leaves: the same, for the normal has it.
inline constexpr double exact_velocity = 1e-9;
/// Steps [1] beyond those that a free ball takes to be out again: a spring of `penalty` pushes for ten.
inline constexpr double steps_to_leave = 24;
/// Steps [1] that are followed at most to see whether a ball comes out behind a plate.
inline constexpr double most_steps_to_leave = 10'000;

/// Phases [1] of the step that a search for a critical speed throws at, one in each part: a share of 1/200 is seen.
inline constexpr std::size_t searched_phases = 200;
/// Factor [1] between a speed that tunnels and one that does not at which the search ends: with `searched_phases` the
/// critical speed is then within 1 %.
inline constexpr double search_bracket = 1.005;
/// Number v dt / reach [1] at which the search begins: few methods that see contacts tunnel below it.
inline constexpr double search_begin = 0.05;
/// Number v dt / reach [1] up to which it looks: a method that does not tunnel there does not tunnel.
inline constexpr double search_end = 1e6;
/// Number v dt / reach [1] down to which it looks where throws tunnel at once: a method that tunnels there does so at
/// any speed.
inline constexpr double search_floor = 1e-6;
/// Factor [1] from speed to speed while it looks for one that tunnels.
inline constexpr double search_stride = 4;

/// Throws [1] that a cell must expect to tunnel, and not to, for its distance from the law to be told in standard
/// deviations: below, the binomial is no normal distribution.
inline constexpr double fewest_expected = 5;

/// Rows [lines] that the terminal shows one by one: more would push the summary off the screen.
inline constexpr std::size_t most_listed_rows = 40;

/// Start [1] of FNV-1a, 64 bits: its authors' number.
inline constexpr std::uint64_t hash_basis = 0xcbf29ce484222325ULL;
/// Factor [1] of FNV-1a, 64 bits: its authors' number.
inline constexpr std::uint64_t hash_prime = 0x100000001b3ULL;

// The default matrix: numbers v dt / reach from 0.008 to 15,000.

/// Throws [1] of each method at each cell: a share is known to 3 %.
inline constexpr std::int64_t default_trials = 1000;
/// Speeds [length/time]: two a decade, from a walk to ten times that of a bullet.
inline constexpr std::array<double, 9> default_speeds{1, 3.16, 10, 31.6, 100, 316, 1000, 3160, 10'000};
/// Thicknesses [length]: sheet, board, wall, were the unit a metre.
inline constexpr std::array<double, 3> default_thickness{0.002, 0.02, 0.2};
/// Radii [length]: a marble and a ball, were the unit a metre.
inline constexpr std::array<double, 2> default_radius{0.01, 0.1};
/// Steps [time]: of a screen, of a careful engine, of a finer one.
inline constexpr std::array<double, 3> default_dt{1.0 / 60, 1.0 / 240, 1.0 / 1000};
/// Offsets [sum of the radii] of spheres whose critical speed is searched for: central, off, grazing.
inline constexpr std::array<double, 3> default_offsets{0, 0.5, 0.9};

}  // namespace carom::tunnel
