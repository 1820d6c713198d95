#include "event_driven/resolve.hpp"

#include "core/expect.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/resolve_impact.hpp"
#include "event_driven/support.hpp"

namespace carom {

namespace {

Resolution resolve_series_end(const State& state, const Key& key)
{
    Resolution out;
    const BodyId id = key.a;
    const int plane = state.plane_index(key.b);
    const Series& series = state.series.at(id);
    const Flight before = state.flight(id);
    const Vec3 normal = facing_normal(state, plane, before.place);
    const SeriesState end = state_at_end(series);

    Flight f = before;
    f.start = key.time;
    f.place = moved(state.frame, before.place, end.shift);
    f.velocity = end.velocity;
    settle(state, id, plane, f);
    // All bounces together, from the balance of momentum.
    const Vec3& g = state.accelerations[state.accelerations.free()];
    const Vec3 impulse = state.sphere(id).mass * ((f.velocity - before.velocity) - series.duration() * g);
    out.events.push_back({EventKind::rest, {}, 0, id, key.b, normal, impulse});
    out.changes.push_back({id, f});
    return out;
}

/// A sphere reached the ball that a series sweeps: the series becomes the bounce it is in.
Resolution resolve_intrusion(const State& state, const Key& key)
{
    Resolution out;
    for (const BodyId body : {key.a, key.b})
        if (!state.is_plane(body) && state.flight(body).mode == Mode::series)
            out.changes.push_back({body, advanced(state, body, key.time)});
    return out;
}

}  // namespace

Resolution resolve(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    switch (key.kind) {
        case Scheduled::pair_impact:
            return resolve_sphere_impact(state, key, neighbourhood);
        case Scheduled::plane_impact:
            return resolve_plane_impact(state, key, neighbourhood);
        case Scheduled::series_end:
            return resolve_series_end(state, key);
        case Scheduled::intrusion:
            return resolve_intrusion(state, key);
        case Scheduled::piece_end:
            return coupled();
        case Scheduled::cell_crossing:
        case Scheduled::nothing:
            break;
    }
    CAROM_EXPECT(false);
    return {};
}

}  // namespace carom
