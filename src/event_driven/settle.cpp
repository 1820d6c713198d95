#include "event_driven/settle.hpp"

#include "event_driven/motion.hpp"
#include "math/error_free.hpp"
#include "toi/sphere_plane.hpp"

#include <cmath>

namespace carom {

bool is_rest(const State& state, BodyId body, const Flight& flight, double w, double gravity)
{
    constexpr double u = unit_roundoff;
    if (gravity > 0) return w * w <= 2 * gravity * 16 * u * (state.radius(body) + state.frame.cell_size);
    if (gravity < 0) return false;
    return w <= 8 * u * std::sqrt(flight.velocity.squaredNorm());
}

Series make_series(const State& state, const Flight& flight, int plane, double w, double gravity, const ContactLaw& law)
{
    const Vec3 normal = facing_normal(state, plane, flight.place);
    Series s;
    s.normal_speed = w;
    s.gravity = gravity;
    s.restitution = law.restitution;
    s.tangential = law.tangential;
    s.velocity = flight.velocity - w / normal.squaredNorm() * normal;
    s.acceleration = state.accelerations[state.accelerations.along(plane)];
    return s;
}

bool series_is_clear(const State& state, BodyId body, const Flight& flight, int plane, const Series& series,
                     const Neighbourhood& neighbourhood)
{
    if (slowed_reach(series) > state.scene.rest.series_below * state.radius(body)) return false;
    // Ask the same functions that will watch the series once it runs.
    Flight bouncing = flight;
    bouncing.mode = Mode::series;
    bouncing.support = plane;
    const Moving trial{body, bouncing, &series};

    bool clear = true;
    for (int p = 0; p < static_cast<int>(state.scene.planes.size()) && clear; ++p) {
        if (p == plane) continue;
        const PlaneMotion m = plane_motion(state, trial, p);
        const Root root = plane_root(m.h, m.w, m.g);
        clear = m.h > 0 && !(root.kind != RootKind::none && root.t < series.duration());
    }
    for (const BodyId other : neighbourhood(body)) {
        if (!clear) break;
        const PairMotion m = pair_motion(state, trial, moving(state, other));
        const Root root = pair_root(state, m);
        clear = m.r.squaredNorm() > m.contact_distance * m.contact_distance &&
                !(root.kind != RootKind::none && root.t < series.duration());
    }
    return clear;
}

void settle(const State& state, BodyId body, int plane, Flight& flight)
{
    const Vec3 normal = facing_normal(state, plane, flight.place);
    const double n2 = normal.squaredNorm();
    flight.place = moved(state.frame, flight.place, (-height_above(state, body, plane, flight.place) / n2) * normal);
    flight.velocity -= (normal.dot(flight.velocity) / n2) * normal;
    hold(state, plane, flight);
}

void hold(const State& state, int plane, Flight& flight)
{
    flight.support = plane;
    flight.acceleration = state.accelerations.along(plane);
    flight.mode = slide_or_rest(state, flight);
}

Mode slide_or_rest(const State& state, const Flight& flight)
{
    return flight.velocity.isZero(0) && state.accelerations[flight.acceleration].isZero(0) ? Mode::resting
                                                                                           : Mode::sliding;
}

}  // namespace carom
