/// \file
/// Time of impact of two spheres under linear drag (flight/damping.hpp).
#pragma once

#include "toi/root.hpp"
#include "toi/sphere_sphere_accelerated.hpp"

namespace carom {

/// First t >= 0 at which |r + v s + a q| <= S and the distance shrinks. Without a relative acceleration that is a
/// straight line in s, which ends at 1/k: sphere_sphere_root decides whether it meets the contact sphere, exact
/// arithmetic whether before its end. With one, (|r + v s + a q|^2)'' (1 - k s)^2 / 2 is a convex function of s: it has
/// two roots at most, which cut time into monotone pieces as in sphere_sphere_accelerated_root. (Method: this project.)
/// \param k of the drag, > 0 [1/time]
Root damped_sphere_sphere_root(const AcceleratedMotion& motion, double k);

}  // namespace carom
