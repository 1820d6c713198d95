/// \file
/// Time of impact of two spheres under the same acceleration: it cancels, the relative motion is uniform, the gap
/// function a quadratic.
///
/// No impact is lost and none is invented against exact arithmetic on r, v and S, except where the sign of an exact
/// quantity is within 64 u^2 of zero, which double-double cannot tell (level 1 then takes the sign that it computes).
#pragma once

#include "toi/root.hpp"

#include <carom/types.hpp>

namespace carom {

/// First t >= 0 at which |r + v t| <= S and the distance shrinks.
/// \param r relative position at the common time [length] \param v relative velocity [length/time] \param
/// contact_distance S = r1 + r2 > 0 [length] Discriminant as A S^2 - |r x v|^2, never B^2 - A C: the textbook form
/// loses grazing and distant impacts to cancellation (error bounds: this project, derived in tests/unit/toi; lengths
/// and speeds within 2^-200 .. 2^200, others are scaled).
Root sphere_sphere_root(const Vec3& r, const Vec3& v, double contact_distance);

/// The sign of r.v: negative means approaching. Decided in double-double where double cannot.
int approach_sign(const Vec3& r, const Vec3& v);

}  // namespace carom
