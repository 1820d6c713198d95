/// \file
/// The gap of two spheres where no speed is needed: at the start of a scene.
#pragma once

#include "scene/tolerances.hpp"

#include <carom/types.hpp>
#include <cmath>

namespace carom {

/// Signed distance of two spheres' surfaces [length]; right for lengths of any size.
inline double sphere_gap(const Vec3& p, double r, const Vec3& q, double s)
{
    const Vec3 d = p - q;
    const double d2 = d.squaredNorm();
    const double distance = d2 > smallest_plain_square && d2 < largest_plain_square ? std::sqrt(d2) : d.stableNorm();
    return distance - (r + s);
}

}  // namespace carom
