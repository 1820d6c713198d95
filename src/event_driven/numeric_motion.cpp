#include "event_driven/numeric_motion.hpp"

#include "event_driven/height.hpp"
#include "event_driven/piece.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Contact of body number `a` with number `b` or what does not move; places relative to `centre`.
NumericContact numeric_contact(const State& state, const NumericPart& part, const NumericPart::Contact& contact,
                               const Place& centre)
{
    const auto number = [&](BodyId body) {
        for (std::size_t k = 0; k < part.bodies.size(); ++k)
            if (part.bodies[k].id == body) return static_cast<int>(k);
        return immovable;
    };
    const Touch& t = contact.touch;
    NumericContact out;
    out.a = number(t.a);
    out.b = number(t.b);
    if (out.a == immovable) std::swap(out.a, out.b);
    out.force = contact.force;
    if (state.is_plane(t.b)) {
        const Flight& f = part.bodies[static_cast<std::size_t>(out.a)].flight;
        out.plane = true;
        out.centre = t.normal / std::sqrt(t.normal.squaredNorm());
        out.reach = out.centre.dot(separation(state.frame, f.place, centre)) - t.gap;
        return out;
    }
    out.reach = state.radius(t.a) + state.radius(t.b);
    if (out.b == immovable) out.centre = separation(state.frame, contact.other, centre);
    return out;
}

/// Largest overlap of the parabolas after a time.
double depth(const NumericCluster& cluster, const std::vector<Vec3>& accelerations, double time)
{
    const auto at = [&](int body) {
        const auto k = static_cast<std::size_t>(body);
        const NumericBody& b = cluster.bodies[k];
        return Vec3(b.position + displacement(b.velocity, accelerations[k], time));
    };
    double deepest = 0;
    for (const NumericContact& c : cluster.contacts) {
        const Vec3 a = at(c.a);
        const Vec3 r = a - (c.plane ? Vec3::Zero() : c.b == immovable ? c.centre : at(c.b));
        const double gap = c.plane ? c.centre.dot(r) - c.reach : std::sqrt(r.squaredNorm()) - c.reach;
        deepest = std::max(deepest, -gap);
    }
    return deepest;
}

}  // namespace

NumericMotion numeric_motion(const State& state, const NumericPart& part, const EpochTime& now, double opening)
{
    const Place centre = part.bodies.front().flight.place;
    auto cluster = std::make_shared<NumericCluster>();
    cluster->gravity = state.accelerations[state.accelerations.free()];
    cluster->opening = opening;
    for (const NumericPart::Body& body : part.bodies)
        cluster->bodies.push_back(
            {separation(state.frame, body.flight.place, centre), body.flight.velocity, state.inverse_mass(body.id)});
    for (const NumericPart::Contact& contact : part.contacts)
        cluster->contacts.push_back(numeric_contact(state, part, contact, centre));
    const auto step = std::make_shared<NumericStep>(numeric_step(*cluster, state.rest.numeric_step));

    NumericMotion out;
    out.forces = step->forces;
    out.correction = step->correction;
    for (std::size_t k = 0; k < part.bodies.size(); ++k) {
        const NumericBody &before = cluster->bodies[k], &after = step->bodies[k];
        out.pieces.push_back(
            {state.frame.after(now, step->duration), Vec3::Zero(), cluster, step, static_cast<int>(k), centre});
        out.accelerations.push_back(
            chord_acceleration(after.position - before.position, before.velocity, step->duration));
    }
    out.depth = depth(*cluster, out.accelerations, 2 * step->duration / 3);
    return out;
}

}  // namespace carom
