#include "event_driven/support.hpp"

#include "event_driven/motion.hpp"
#include "math/error_free.hpp"
#include "scene/pair_gap.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

Mode slide_or_rest(const State& state, const Flight& flight)
{
    return flight.velocity.isZero(0) && state.accelerations[flight.acceleration].isZero(0) ? Mode::resting
                                                                                           : Mode::sliding;
}

}  // namespace

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

SupportAfterImpact keep_to_support(const State& state, Flight& f)
{
    if (f.support < 0) return SupportAfterImpact::none;
    const Vec3 normal = facing_normal(state, f.support, f.place);
    const double c = normal.dot(f.velocity) / normal.squaredNorm();
    const double slack =
        std::max(1e-6 * state.rest.closing_speed, 16 * unit_roundoff * std::sqrt(f.velocity.squaredNorm()));
    if (std::abs(c) <= slack) {
        f.velocity -= c * normal;
        f.mode = slide_or_rest(state, f);
        return SupportAfterImpact::kept;
    }
    if (c < 0) return SupportAfterImpact::pushed;
    f.support = -1;
    f.mode = Mode::flying;
    f.acceleration = state.accelerations.free();
    return SupportAfterImpact::released;
}

Event release_event(const State& state, BodyId body, const Flight& before)
{
    Event event;
    event.kind = EventKind::release;
    event.a = body;
    event.b = state.scene.plane_body(static_cast<std::size_t>(before.support));
    event.normal = facing_normal(state, before.support, before.place);
    return event;
}

std::vector<Change> initial_contacts(const State& state)
{
    std::vector<Change> changes;
    for (BodyId id = 0; id < state.count(); ++id)
        for (int p = 0; p < static_cast<int>(state.scene.planes.size()); ++p) {
            Flight f = state.flight(id);
            if (std::abs(height_above(state, id, p, f.place)) > declared_contact * state.radius(id)) continue;
            const Vec3 normal = facing_normal(state, p, f.place);
            const double gravity = -normal.dot(state.accelerations[f.acceleration]);
            const double w = normal.dot(f.velocity);
            if (!(gravity > 0) || std::abs(w) > 8 * unit_roundoff * std::sqrt(f.velocity.squaredNorm())) continue;
            f.velocity -= w / normal.squaredNorm() * normal;  // what slides along a tilted plane rounds
            hold(state, p, f);
            changes.push_back({id, f});
            break;
        }
    return changes;
}

}  // namespace carom
