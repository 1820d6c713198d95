#include "event_driven/resolve.hpp"

#include "core/expect.hpp"
#include "event_driven/resolve_component.hpp"
#include "event_driven/resolve_impact.hpp"
#include "hold/support.hpp"
#include "motion/relative.hpp"

namespace carom {

namespace {

void end_series(const State& state, const Key& key, EventOutcome& out)
{
    const BodyId id = key.a;
    const Bouncing& bouncing = *state.bodies.as<Bouncing>(id);
    const Flight& before = state.flight(id);
    const Vec3 normal = facing_normal(state, bouncing.plane, before.place);
    const SeriesState end = state_at_end(bouncing.series);

    Change change{id, before};
    change.flight.start = key.time;
    change.flight.place = moved(state.frame, before.place, end.shift);
    change.flight.velocity = end.velocity;
    settle(state, bouncing.plane, change);
    // All bounces together, from the balance of momentum.
    const Vec3 impulse = state.sphere(id).mass *
                         ((change.flight.velocity - before.velocity) - bouncing.series.duration() * state.gravity());
    out.events.push_back(make_event(state, EventKind::rest, id, key.b, normal, impulse));
    out.changes.push_back(change);
}

/// A sphere reached the ball that a series sweeps: the series becomes the bounce it is in.
void end_series_inside(const State& state, const Key& key, EventOutcome& out)
{
    const auto interrupt = [&](BodyId body) {
        if (state.bodies.kind(body) != MotionKind::bouncing) return;
        add_change(state, body, key.time, out).motion = Flying{};
    };
    interrupt(key.a);
    if (key.b.is_sphere()) interrupt(key.b.index);
}

}  // namespace

Event make_event(const State& state, EventKind kind, BodyId a, Partner b, const Vec3& normal, const Vec3& impulse)
{
    const BodyId other = state.body_of(b);
    if (a < other) return {kind, {}, 0, a, other, normal, impulse};
    return {kind, {}, 0, other, a, -normal, -impulse};
}

bool resolve(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out)
{
    switch (key.kind) {
        case Scheduled::pair_impact:
            if (resolve_sphere_impact(state, key, neighbourhood, out)) return true;
            break;
        case Scheduled::plane_impact:
            if (resolve_plane_impact(state, key, neighbourhood, out)) return true;
            break;
        case Scheduled::series_end:
            end_series(state, key, out);
            return true;
        case Scheduled::intrusion:
            end_series_inside(state, key, out);
            return true;
        case Scheduled::piece_end:
            break;
        case Scheduled::cell_crossing:
        case Scheduled::nothing:
            CAROM_EXPECT(false);
    }
    const std::optional<EarlyRest> early_rest = out.early_rest;
    out.clear();
    out.early_rest = early_rest;
    resolve_component(state, key, neighbourhood, out);
    return false;
}

}  // namespace carom
