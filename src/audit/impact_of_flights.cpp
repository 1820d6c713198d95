#include "audit/impact_of_flights.hpp"

#include "audit/tolerances.hpp"
#include "toi/damped_plane.hpp"
#include "toi/damped_sphere_sphere.hpp"

#include <carom/time_of_impact.hpp>

#include <algorithm>

namespace carom::audit {

namespace {

MovingSphere moving(const Parabola& flight, double time, double radius)
{
    return {flight.place_at(time), flight.velocity_at(time), flight.pull.acceleration, radius};
}

ImpactOfFlights told(const TimeOfImpact& toi)
{
    return {toi.status != ImpactStatus::none, toi.t, toi.t_lo, toi.t_hi, toi.approach_speed, toi.normal};
}

/// An impact by a damped root, whose bounds are those of its roundings.
ImpactOfFlights damped(double t)
{
    const double error = damped_time_roundings * double_rounding * t;
    return {true, t, std::max(0.0, t - error), t + error, 0, Vec3::Zero()};
}

/// The plane, or the side of a plate on which the centre is, as a plane with one side.
Plane side_of(const Plane& plane, const Vec3& centre)
{
    if (!plane.thickness) return plane;
    Plane side = plane;
    side.thickness.reset();
    const bool behind = plane.normal.dot(centre) < plane.offset;
    if (behind) {
        side.normal = -plane.normal;
        side.offset = -plane.offset;
    }
    side.offset += *plane.thickness / 2;
    return side;
}

}  // namespace

ImpactOfFlights impact_of(const Parabola& a, double radius_a, const Parabola& b, double radius_b)
{
    const double k = a.pull.drag;
    if (k == 0) return told(time_of_impact(moving(a, a.time, radius_a), moving(b, a.time, radius_b)));
    const Parabola apart = relative(a, b);
    const AcceleratedMotion motion{apart.place, apart.velocity, apart.pull.acceleration, radius_a + radius_b};
    const Root root = damped_sphere_sphere_root(motion, k);
    if (root.kind != RootKind::impact) return {};
    ImpactOfFlights impact = damped(root.t);
    impact.normal = apart.place_at(a.time + root.t).normalized();
    impact.approach_speed = std::max(0.0, -apart.velocity_at(a.time + root.t).dot(impact.normal));
    return impact;
}

ImpactOfFlights impact_of(const Parabola& flight, double radius, const Plane& plane)
{
    const double k = flight.pull.drag;
    if (k == 0) return told(time_of_impact(moving(flight, flight.time, radius), plane));
    const Plane side = side_of(plane, flight.place);
    const double height = side.normal.dot(flight.place) - side.offset - radius;
    const Root root =
        damped_plane_root(height, side.normal.dot(flight.velocity), side.normal.dot(flight.pull.acceleration), k);
    if (root.kind != RootKind::impact) return {};
    ImpactOfFlights impact = damped(root.t);
    impact.normal = side.normal;
    impact.approach_speed = std::max(0.0, -side.normal.dot(flight.velocity_at(flight.time + root.t)));
    return impact;
}

}  // namespace carom::audit
