/// \file
/// A light sphere to and fro between a wall and a heavy one that comes in, impact by impact in extended precision.
#pragma once

#include "study/stress/trial.hpp"

namespace carom::stress {

struct Shuttle {
    long double light = 0, heavy = 0;              ///< in: places of the two, 0 < light < heavy, see below [length]
    long double light_speed = 0, heavy_speed = 0;  ///< away from the wall [length/time]
    std::int64_t impacts = 0;
};

/// Points stand for the spheres: the light one at 0 touches the wall, both at one place touch each other. Elastic.
/// \param mass of the heavy one in those of the light one \param time how long [time]
Shuttle after(Shuttle now, long double mass, long double time);

/// What a trial expects of its spheres 0 (light) and 1 (heavy, coming in along x), before a wall at x = 0.
void expect_shuttle(Trial& trial);

}  // namespace carom::stress
