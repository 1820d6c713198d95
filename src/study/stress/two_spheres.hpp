/// \file
/// Closed form of two spheres that meet once, freely and elastically, in extended precision.
#pragma once

#include "study/stress/trial.hpp"

namespace carom::stress {

struct Meeting {
    double time = 0;  ///< of the impact [time]
    ExpectedState a, b;
};

/// \pre spheres `a` and `b` of the scene meet before its end and nothing else matters to them. Lengths count relative
/// to the radius of each, speeds relative to its own afterwards.
Meeting meeting(const Scene& scene, BodyId a, BodyId b);

/// Their expected states and their one impact, in a trial.
void expect_meeting(Trial& trial, BodyId a, BodyId b);

/// A sphere that meets nobody.
ExpectedState free_flight(const Scene& scene, BodyId body);

}  // namespace carom::stress
