/// \file
/// The limits of core: unit, value, reason.
#pragma once

namespace carom {

/// Draws [points of a cube] for one direction: one lies in the ball with probability pi/6, all miss it with 1e-64.
inline constexpr int most_direction_draws = 200;
/// Square of the distance [half edges of the cube, squared] from its centre within which a point gives no direction:
/// coordinates are multiples of 2^-52, so that one at 0.01 is off by less than 4e-14. One of two million is drawn
/// again.
inline constexpr double least_direction_square = 1e-4;

}  // namespace carom
