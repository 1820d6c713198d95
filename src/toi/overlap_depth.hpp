/// \file
/// How deep two bodies overlap at t = 0. An overlap is none by the sign of exact arithmetic, as everywhere in `toi`.
#pragma once

#include <carom/time_of_impact.hpp>

namespace carom {

/// Of two spheres, to rounding; 0 if the exact gap is >= 0 [length]. \pre as `time_of_impact`
double overlap_depth(const MovingSphere& a, const MovingSphere& b);

/// Of a sphere and a plane or plate. \pre as `time_of_impact`
double overlap_depth(const MovingSphere& sphere, const Plane& plane);

}  // namespace carom
