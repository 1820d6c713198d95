#include "hold/low_bounce.hpp"

#include "motion/relative.hpp"
#include "toi/sphere_plane.hpp"

#include <cmath>

namespace carom {

Series make_series(const State& state, const Flight& flight, int plane, double w, double gravity, const ContactLaw& law)
{
    const Vec3 normal = facing_normal(state, plane, flight.place);
    const Accelerations& accelerations = state.bodies.accelerations();
    Series s;
    s.normal_speed = w;
    s.gravity = gravity;
    s.restitution = law.restitution;
    s.tangential = law.tangential;
    s.velocity = flight.velocity - w / normal.squaredNorm() * normal;
    s.acceleration = accelerations[accelerations.along(plane)];
    return s;
}

bool series_is_clear(const State& state, BodyId body, const Flight& flight, const Bouncing& bouncing,
                     const Neighbourhood& neighbourhood)
{
    const Series& series = bouncing.series;
    if (slowed_reach(series) > state.scene.rest.series_below * state.radius(body)) return false;
    // Ask the same functions that will watch the series once it runs.
    const Moving trial{body, flight, &bouncing};
    const auto comes = [&](const Root& root) { return root.kind != RootKind::none && root.t < series.duration(); };
    for (int p = 0; p < state.planes(); ++p) {
        if (p == bouncing.plane) continue;
        const PlaneMotion m = plane_motion(state, trial, p);
        if (!(m.h > 0) || comes(plane_root(m.h, m.w, m.g))) return false;
    }
    for (const BodyId other : neighbourhood(body)) {
        const PairMotion m = pair_motion(state, trial, moving(state, other));
        if (!(m.r.squaredNorm() > m.contact_distance * m.contact_distance) || comes(pair_root(state, m))) return false;
    }
    return true;
}

}  // namespace carom
