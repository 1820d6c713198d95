#include "study/lift_watch.hpp"

#include "scene/pair_gap.hpp"
#include "study/flight_state.hpp"

namespace carom::study {

LiftWatch::LiftWatch(const Scene& scene) : scene_(scene)
{
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere& sphere = scene.spheres[i];
        if (sphere.fixed) continue;
        for (std::size_t p = 0; p < scene.planes.size(); ++p)
            if (plane_gap(scene.planes[p], sphere, sphere.position) < -declared_contact * sphere.radius)
                watched_.push_back({static_cast<BodyId>(i), p, {}});
    }
}

void LiftWatch::on_frame(const RunFrame& frame)
{
    frame_ = frame;
}

void LiftWatch::on_flight(const FlightRecord& flight)
{
    for (Watched& each : watched_) {
        if (each.sphere != flight.body) continue;
        if (each.has_flight) compare(each, flight);
        each.flight = flight;
        each.has_flight = true;
    }
}

Vec3 LiftWatch::place_at(const FlightRecord& flight, const EpochTime& time) const
{
    const double t = static_cast<double>(time.epoch - flight.start.epoch) * frame_.epoch_length +
                     (time.offset - flight.start.offset);
    return place_after(place_of(frame_, flight), vector_of(flight.velocity), acceleration_of(frame_, flight),
                       frame_.drag, t);
}

double LiftWatch::gap_at_end(const Watched& watched, const EpochTime& end) const
{
    const bool is_series = watched.flight.mode == Mode::series;
    return plane_gap(scene_.planes[watched.plane], scene_.spheres[static_cast<std::size_t>(watched.sphere)],
                     place_at(watched.flight, is_series ? watched.flight.start : end));
}

void LiftWatch::compare(const Watched& watched, const FlightRecord& next)
{
    const Sphere& sphere = scene_.spheres[static_cast<std::size_t>(watched.sphere)];
    const Plane& plane = scene_.planes[watched.plane];
    const Vec3 place = place_at(next, next.start);
    const double before = gap_at_end(watched, next.start), depth = plane_gap(plane, sphere, place) - before;
    if (!(before < 0 && depth > declared_contact * sphere.radius)) return;
    const bool is_behind = plane.thickness && plane.normal.dot(place) < plane.offset;
    const Vec3 out = is_behind ? Vec3(-plane.normal) : plane.normal;
    const double weight = 0 - sphere.mass * scene_.gravity.dot(out);  // 0, not -0, beside a wall
    lifts_.push_back({watched.sphere, scene_.plane_body(watched.plane), depth, weight * depth});
}

}  // namespace carom::study
