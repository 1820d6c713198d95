/// \file
/// A ball that is dropped onto a floor, as frames have it.
#pragma once

#include "paths.hpp"
#include "support/scenes.hpp"

#include <cmath>
#include <vector>

namespace carom::test {

inline constexpr double rate = 240;  // frames a second

/// A ball of radius 0.1 that falls 1 m onto the floor: it touches at sqrt(2/g) with speed sqrt(2 g).
struct Drop {
    Scene scene = empty_scene(1, earth);
    double touch = std::sqrt(2 / 9.81), speed = std::sqrt(2 * 9.81);
    Path path{{0, {0, 0, 1.1}, Vec3::Zero()}};

    Drop()
    {
        add_floor(scene);
        add_sphere(scene, 0.1, {0, 0, 1.1});
    }
    void bounce_at(double time) { turn(path, earth, time, {0, 0, speed - 9.81 * (time - touch)}); }
    audit::TraceAudit audited(const std::vector<double>& times = equal_times(rate, 0.8)) const
    {
        Frames frames = frames_of({path}, earth, times);
        return audit::audit_trace(scene, frames);
    }
};

}  // namespace carom::test
