/// \file
/// The gap of two spheres where no speed is needed: at the start of a scene.
#pragma once

#include <carom/types.hpp>
#include <cmath>

namespace carom {

/// A gap within this fraction of the smaller radius is a contact that the scene declares.
inline constexpr double declared_contact = 1e-9;

/// Signed distance of two spheres' surfaces [length]; right for lengths of any size.
inline double sphere_gap(const Vec3& p, double r, const Vec3& q, double s)
{
    constexpr double smallest = 1e-280, largest = 1e280;  // squares beyond these over- or underflow
    const Vec3 d = p - q;
    const double d2 = d.squaredNorm();
    const double distance = d2 > smallest && d2 < largest ? std::sqrt(d2) : d.stableNorm();
    return distance - (r + s);
}

}  // namespace carom
