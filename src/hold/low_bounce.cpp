#include "hold/low_bounce.hpp"

#include "gather/instant.hpp"
#include "math/exponential.hpp"
#include "motion/relative.hpp"
#include "toi/sphere_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

DampedBounces damped_bounces(const State& state, const Key& key, const Flight& flight, double w, double gravity,
                             const ContactLaw& law, const Neighbourhood& neighbourhood)
{
    const double loss = 1 - law.restitution, scale = state.radius(key.a) + state.frame.cell_size;
    // A bounce loses 1 - e of its speed to the plane and 2 k w / 3 g to drag, so that with e = 1 some 3 g / (2 k w)
    // are to come until the last speed w that is no rest, and in the time T that is left g/2w a time, e^(k T / 3) times
    // as many a time in the end.
    const double last = std::sqrt(2 * rest_height * scale) * std::sqrt(gravity);
    const double by_drag = 1.5 * gravity / state.drag / last;
    const double left = state.scene.end_time - state.frame.seconds(key.time), grown = state.drag * left / 3;
    const double until_end = left > 0 && grown < most_growth ? gravity / (2 * w) * left * exponential(grown)
                                                             : std::numeric_limits<double>::infinity();
    if (std::min({bounces_of_rounding / loss, by_drag, until_end}) > most_bounces) {
        if (!(w < state.rest.closing_speed) || state.scene.rest.policy != RestPolicy::contact) return {};
        const double early = std::min(2 * w / gravity / loss, 3 / state.drag * logarithm(std::max(w / last, 1.0)));
        return {.early = left > 0 ? std::min(early, left) : early};
    }
    return {.die_out = is_apart(state, flight, key.a, key.b, neighbourhood)};
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
