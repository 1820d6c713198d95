#include "hold/support.hpp"

#include "hold/tolerances.hpp"
#include "motion/height.hpp"
#include "scene/pair_gap.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

Leaning leaning(const State& state, int plane, const Flight& flight)
{
    return {plane, flight.velocity.isZero(0) && state.acceleration(flight).isZero(0)};
}

}  // namespace

void settle(const State& state, int plane, Change& change)
{
    Flight& f = change.flight;
    const Vec3 normal = facing_normal(state, plane, f.place);
    const double n2 = normal.squaredNorm();
    f.place = moved(state.frame, f.place, (-height_above(state, change.body, plane, f.place) / n2) * normal);
    f.velocity -= (normal.dot(f.velocity) / n2) * normal;
    lean(state, plane, change);
}

void lean(const State& state, int plane, Change& change)
{
    std::fill_n(change.flight.place.low, 3, 0.0);
    change.flight.acceleration = state.bodies.accelerations().along(plane);
    change.motion = leaning(state, plane, change.flight);
}

SupportAfterImpact keep_to_support(const State& state, Change& change)
{
    const auto* support = std::get_if<Leaning>(&change.motion);
    if (!support) return SupportAfterImpact::none;
    Flight& f = change.flight;
    const Vec3 normal = facing_normal(state, support->plane, f.place);
    const double c = normal.dot(f.velocity) / normal.squaredNorm();
    if (std::abs(c) <= state.tolerances.speed) {
        f.velocity -= c * normal;
        change.motion = leaning(state, support->plane, f);
        return SupportAfterImpact::kept;
    }
    if (c < 0) return SupportAfterImpact::pushed;
    change.motion = Flying{};
    f.acceleration = state.bodies.accelerations().free();
    return SupportAfterImpact::released;
}

std::vector<Change> initial_contacts(const State& state)
{
    std::vector<Change> changes;
    for (BodyId id = 0; id < state.count(); ++id)
        for (int p = 0; p < state.planes(); ++p) {
            Change change{id, state.flight(id)};
            Flight& f = change.flight;
            if (std::abs(height_above(state, id, p, f.place)) > declared_contact * state.radius(id)) continue;
            const Vec3 normal = facing_normal(state, p, f.place);
            const double gravity = -normal.dot(state.acceleration(f));
            const double w = normal.dot(f.velocity);
            if (!(gravity > 0) || std::abs(w) > no_normal_speed * std::sqrt(f.velocity.squaredNorm())) continue;
            f.velocity -= w / normal.squaredNorm() * normal;  // what slides along a tilted plane rounds
            lean(state, p, change);
            changes.push_back(change);
            break;
        }
    return changes;
}

}  // namespace carom
