/// \file
/// Depth of the overlap of two bodies at t = 0. Whether they overlap is decided by exact arithmetic, as everywhere in
/// `toi`.
#pragma once

#include <carom/time_of_impact.hpp>

namespace carom {

/// Depth for two spheres, to rounding; 0 if the exact gap is >= 0 [length]. \pre as `time_of_impact`
double overlap_depth(const MovingSphere& a, const MovingSphere& b);

/// Depth for a sphere and a plane or plate, likewise [length]. \pre as `time_of_impact`
double overlap_depth(const MovingSphere& sphere, const Plane& plane);

}  // namespace carom
