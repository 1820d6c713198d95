#include "audit/touch.hpp"

#include "audit/impact_of_flights.hpp"

#include <algorithm>
#include <cmath>

namespace carom::audit {

namespace {

/// Height of an arc over its chord [length]. \param bend its largest acceleration
double sagitta(double bend, double duration)
{
    return bend * duration * duration / 8;
}

/// Distance of the origin from the chord between two places [length].
double distance_of_chord(const Vec3& from, const Vec3& to)
{
    const Vec3 way = to - from;
    const double length2 = way.squaredNorm();
    const double part = length2 > 0 ? std::clamp(-from.dot(way) / length2, 0.0, 1.0) : 0;
    return (from + part * way).norm();
}

double radius_of(const Scene& scene, BodyId body)
{
    return scene.spheres[static_cast<std::size_t>(body)].radius;
}

/// Times of impact with the largest, the given and the smallest radius that errors allow.
struct Times {
    ImpactOfFlights early, given, late;
    bool has_late = true;  ///< errors leave something of the body
};

/// \param error of the gap until the end of the interval [length] \param speed_error [length/time]
std::optional<Touch> touch_of(const Times& times, double begin, double duration, double gap_now, double error,
                              double speed_error)
{
    if (gap_now < -error) return std::nullopt;
    const bool closed = gap_now <= error;
    const bool may = times.early && times.early.t_lo <= duration;
    if (!closed && !may) return std::nullopt;
    Touch touch;
    // Bodies that lean on each other touch without approaching.
    const bool leans = closed && times.given.approach_speed <= speed_error;
    touch.is_certain = !leans && times.has_late && times.late && times.late.t_hi <= duration && times.given;
    touch.grazes = !touch.is_certain && !closed && !(times.has_late && times.late);
    if (!touch.is_certain) return touch;
    touch.earliest = begin + (closed || !times.early ? 0 : times.early.t_lo);
    touch.time = begin + times.given.t;
    touch.latest = begin + times.late.t_hi;
    touch.approach_speed = times.given.approach_speed;
    touch.normal = times.given.normal;
    return touch;
}

}  // namespace

double gap(const Scene& scene, BodyId a, const Vec3& place, BodyId b, const Vec3& other)
{
    const auto n = static_cast<BodyId>(scene.spheres.size());
    if (b < n) return (place - other).norm() - radius_of(scene, a) - radius_of(scene, b);
    return plane_gap(scene.planes[static_cast<std::size_t>(b - n)], scene.spheres[static_cast<std::size_t>(a)], place);
}

bool is_behind(const Plane& plane, const Vec3& place)
{
    return plane.normal.dot(place) < plane.offset;
}

bool may_touch(const Scene& scene, BodyId a, const Parabola& flight_a, BodyId b, const Parabola& flight_b, double begin,
               double end)
{
    const double error = std::max(flight_a.error_at(begin), flight_a.error_at(end)) +
                         std::max(flight_b.error_at(begin), flight_b.error_at(end));
    const Vec3 from = flight_a.place_at(begin) - flight_b.place_at(begin);
    const Vec3 to = flight_a.place_at(end) - flight_b.place_at(end);
    return distance_of_chord(from, to) <= radius_of(scene, a) + radius_of(scene, b) + error +
                                              sagitta(relative(flight_a, flight_b).bend(begin, end), end - begin);
}

bool may_touch_plane(const Scene& scene, BodyId a, const Parabola& flight, std::size_t plane, double begin, double end)
{
    const Plane& p = scene.planes[plane];
    const Sphere& sphere = scene.spheres[static_cast<std::size_t>(a)];
    const Vec3 from = flight.place_at(begin), to = flight.place_at(end);
    if (p.thickness && is_behind(p, from) != is_behind(p, to)) return true;
    return std::min(plane_gap(p, sphere, from), plane_gap(p, sphere, to)) <=
           std::max(flight.error_at(begin), flight.error_at(end)) + sagitta(flight.bend(begin, end), end - begin);
}

std::optional<Touch> sphere_touch(const Scene& scene, BodyId a, const Parabola& flight_a, BodyId b,
                                  const Parabola& flight_b, double end)
{
    const double begin = flight_a.time;
    if (!may_touch(scene, a, flight_a, b, flight_b, begin, end)) return std::nullopt;
    const double error = flight_a.error_at(end) + flight_b.error_at(end), radius = radius_of(scene, a);
    const double other = radius_of(scene, b);
    Times times;
    times.early = impact_of(flight_a, radius + error, flight_b, other);
    times.given = impact_of(flight_a, radius, flight_b, other);
    // The error is taken from one radius: it may be larger than that of a small sphere, not than their sum.
    times.has_late = error < radius;
    if (times.has_late) times.late = impact_of(flight_a, radius - error, flight_b, other);
    const double gap_now = gap(scene, a, flight_a.place_at(begin), b, flight_b.place_at(begin));
    std::optional<Touch> touch =
        touch_of(times, begin, end - begin, gap_now, error, flight_a.velocity_error + flight_b.velocity_error);
    if (!touch) return std::nullopt;
    touch->a = a;
    touch->b = b;
    const double nearest = distance_of_chord(flight_a.place_at(begin) - flight_b.place_at(begin),
                                             flight_a.place_at(end) - flight_b.place_at(end));
    touch->depth = std::max(0.0, radius + radius_of(scene, b) - nearest);
    return touch;
}

std::optional<Touch> plane_touch(const Scene& scene, BodyId a, const Parabola& flight, std::size_t plane, double end)
{
    const double begin = flight.time;
    if (!may_touch_plane(scene, a, flight, plane, begin, end)) return std::nullopt;
    const Plane& p = scene.planes[plane];
    const double error = flight.error_at(end), radius = radius_of(scene, a);
    Times times;
    times.early = impact_of(flight, radius + error, p);
    times.given = impact_of(flight, radius, p);
    times.has_late = error < radius;
    if (times.has_late) times.late = impact_of(flight, radius - error, p);
    const BodyId body = scene.plane_body(plane);
    std::optional<Touch> touch =
        touch_of(times, begin, end - begin, gap(scene, a, flight.place_at(begin), body, Vec3::Zero()), error,
                 flight.velocity_error);
    if (!touch) return std::nullopt;
    touch->a = a;
    touch->b = body;
    const bool through = p.thickness && is_behind(p, flight.place_at(begin)) != is_behind(p, flight.place_at(end));
    touch->depth =
        through ? radius + *p.thickness / 2 : std::max(0.0, -gap(scene, a, flight.place_at(end), body, Vec3::Zero()));
    return touch;
}

}  // namespace carom::audit
