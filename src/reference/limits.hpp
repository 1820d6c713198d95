/// \file
/// The few numbers that the reference decides by.
#pragma once

#include <cstdint>

namespace carom::reference {

inline constexpr std::int64_t max_impacts = 2'000'000;
/// Contacts closer than this are one instant (in radii); those of the scene's start are within 1e-9 r, by contract.
inline constexpr double tie = 1e-12, declared_tie = 1e-9;
/// A start slower than this fraction of v_c, or than two roundings of the speed, is at rest: normals and velocities are
/// doubles.
inline constexpr double still = 1e-6, still_rounding = 0x1p-51;
/// Bounces lower than this fraction of the radius are over.
inline constexpr double lowest_bounce = 1e-60;

}  // namespace carom::reference
