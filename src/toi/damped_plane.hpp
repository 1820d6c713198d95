/// \file
/// Time of impact of a sphere and a plane under linear drag: the height h + w s + g q above contact turns at most once
/// (flight/damping.hpp has s and q). Also cell walls.
#pragma once

#include "toi/root.hpp"

namespace carom {

/// First t >= 0 at which the height is <= 0 and falls, as `plane_root` has it: h <= 0 with w >= 0 is not now. Whether a
/// sphere arrives is decided as exact arithmetic on h, w, g and k would: one that coasts to a stand exactly at the
/// plane does not.
/// \param h height at the common time [length] \param w its rate [length/time] \param g its acceleration without drag
/// [length/time^2] \param k of the drag, > 0 [1/time]
Root damped_plane_root(double h, double w, double g, double k);

}  // namespace carom
