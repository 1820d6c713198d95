/// \file
/// Touches of two bodies that fly as frames show them: exact times of impact, as early and as late as errors allow.
#pragma once

#include "audit/parabola.hpp"

#include <carom/scene.hpp>

namespace carom::audit {

struct Touch {
    BodyId a = no_body, b = no_body;            ///< a sphere that moves; the other sphere or the plane
    bool is_certain = false;                    ///< they touch whatever the errors are; else they may
    bool grazes = false;                        ///< not certain, though one of them comes from outside
    double earliest = 0, time = 0, latest = 0;  ///< the time between its bounds, if certain [time]
    double approach_speed = 0;                  ///< [length/time]
    Vec3 normal = Vec3::Zero();                 ///< from b to a
    double depth = 0;                           ///< of the overlap if both fly on to the end, at its deepest [length]
};

/// Signed distance of a sphere at `place` from another sphere or a plane; `other` is used for a sphere [length].
double gap(const Scene& scene, BodyId a, const Vec3& place, BodyId b, const Vec3& other);

/// The first touch of spheres a and b from `a.time` until `end`; none if they cannot touch, or overlap already.
std::optional<Touch> sphere_touch(const Scene& scene, BodyId a, const Parabola& flight_a, BodyId b,
                                  const Parabola& flight_b, double end);
/// Likewise of sphere a and a plane.
std::optional<Touch> plane_touch(const Scene& scene, BodyId a, const Parabola& flight, std::size_t plane, double end);

/// Whether spheres, or a sphere and a plane, may touch between these times.
bool may_touch(const Scene& scene, BodyId a, const Parabola& flight_a, BodyId b, const Parabola& flight_b, double begin,
               double end);
bool may_touch_plane(const Scene& scene, BodyId a, const Parabola& flight, std::size_t plane, double begin, double end);

/// Whether the centre is behind a plate or a plane, seen from its normal.
bool is_behind(const Plane& plane, const Vec3& place);

}  // namespace carom::audit
