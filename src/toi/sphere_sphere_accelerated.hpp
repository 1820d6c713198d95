/// \file
/// Time of impact of two spheres under different accelerations (one supported, one flying): the gap function is a
/// quartic.
#pragma once

#include "toi/root.hpp"

#include <carom/types.hpp>

namespace carom {

/// Relative motion r + v t + a t^2/2 from a common time.
struct AcceleratedMotion {
    Vec3 r, v, a;             ///< [length], [length/time], [length/time^2]
    double contact_distance;  ///< S = r1 + r2 > 0 [length]
};

/// First t >= 0 at which |p(t)| <= S and the distance shrinks; where the spheres overlap and separate, the next time
/// that they close. The quartic F = |p|^2 - S^2 is never expanded into coefficients: roots of H' (a quadratic) cut time
/// into monotone pieces of H = p.w = F'/2, the roots of H cut it into monotone pieces of F, and F is evaluated
/// geometrically. A sign within the rounding of double is evaluated in double-double. Method: this project.
Root sphere_sphere_accelerated_root(const AcceleratedMotion& motion);

}  // namespace carom
