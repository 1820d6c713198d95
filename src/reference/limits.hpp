/// \file
/// The few numbers that the reference decides by.
#pragma once

#include <cstddef>
#include <cstdint>

namespace carom::reference {

inline constexpr std::int64_t max_impacts = 2'000'000;
/// Contacts closer than this are one instant (in radii), unless the scene says otherwise; those of the scene's start
/// are within 1e-9 r, by contract.
inline constexpr double tie = 1e-12, declared_tie = 1e-9;
/// Contacts slower than this fraction of v_c, or than two roundings of the speeds, persist: normals and velocities are
/// doubles.
inline constexpr double still = 1e-6, still_rounding = 0x1p-51;
/// Bounces lower than this fraction of the radius are over.
inline constexpr double lowest_bounce = 1e-60;
/// What is below this fraction of its scale comes from the scene's doubles: closing speeds and accelerations of
/// contacts that hold each other. Its square tells which rows of a coupling are sums of others.
inline constexpr double noise = 1e-12, dependent = 1e-24;
/// Unit normals with a convex combination shorter than this are jammed.
inline constexpr double jam = 1e-7;
/// Contacts resolved together: the work grows with their cube, and more.
inline constexpr std::size_t most_contacts = 128;

}  // namespace carom::reference
