/// \file
/// Time of impact of two spheres under the same acceleration: it cancels, the relative motion is uniform, the gap
/// function a quadratic.
///
/// No impact is lost and none is invented against exact arithmetic on r, v and S: a sign that double-double cannot tell
/// is taken exactly (docs/numerics.md, section 2).
#pragma once

#include "toi/root.hpp"

#include <carom/types.hpp>

namespace carom {

/// First t >= 0 at which |r + v t| <= S and the distance shrinks. The discriminant is A S^2 - |r x v|^2, never B^2 - A
/// C: the textbook form loses grazing and distant impacts to cancellation (error bounds: this project,
/// src/toi/ERROR_BOUNDS.md). Lengths and speeds outside 2^-100 .. 2^100 are scaled.
/// \param r relative position at the common time [length]
/// \param v relative velocity [length/time]
/// \param contact_distance S = r1 + r2 > 0 [length]
Root sphere_sphere_root(const Vec3& r, const Vec3& v, double contact_distance);

/// The sign of r.v, always right: negative means approaching.
int approach_sign(const Vec3& r, const Vec3& v);

}  // namespace carom
