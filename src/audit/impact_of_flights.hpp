/// \file
/// Times of impact of flights as frames show them: the exact ones of carom, with drag and without.
#pragma once

#include "audit/parabola.hpp"

#include <carom/scene.hpp>

namespace carom::audit {

struct ImpactOfFlights {
    bool comes = false;          ///< false: never, if these motions go on
    double t = 0;                ///< since the time at which the first flight is given, >= 0 [time]
    double t_lo = 0, t_hi = 0;   ///< the exact time is between them [time]
    double approach_speed = 0;   ///< at t [length/time]
    Vec3 normal = Vec3::Zero();  ///< at t, from the other body to the first

    explicit operator bool() const { return comes; }
};

/// \pre both have one drag, or b stands still
ImpactOfFlights impact_of(const Parabola& a, double radius_a, const Parabola& b, double radius_b);
/// A plate is hit on the side on which the centre is at first.
ImpactOfFlights impact_of(const Parabola& flight, double radius, const Plane& plane);

}  // namespace carom::audit
