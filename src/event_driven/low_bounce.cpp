#include "event_driven/low_bounce.hpp"

#include "event_driven/motion.hpp"
#include "toi/sphere_plane.hpp"

#include <cmath>

namespace carom {

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

}  // namespace carom
