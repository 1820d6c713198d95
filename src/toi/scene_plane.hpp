/// \file
/// Height, rate and acceleration of a sphere over a plane, from the numbers of a scene: in double-double with bounds,
/// and exactly.
#pragma once

#include "toi/bounded.hpp"

#include <carom/types.hpp>

namespace carom {

/// h = n.x - d - r, w = n.v, g = n.a. A policy of PlaneSolver.
struct ScenePlane {
    static constexpr bool available = true;
    Vec3 normal = Vec3::Zero();
    double offset = 0, half_thickness = 0, radius = 0;
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();

    /// The height n.x - d of the centre; its sign is the side of a plate on which the centre is.
    Bounded bounded_height() const;
    Dyadic height() const;

    Bounded bounded_h() const;
    Bounded bounded_w() const;
    Bounded bounded_g() const;
    Dyadic h() const;
    Dyadic w() const;
    Dyadic g() const;
};

}  // namespace carom
