#include "event_driven/low_bounce.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/resolve_impact.hpp"
#include "event_driven/simultaneous.hpp"
#include "event_driven/support.hpp"
#include "impact/pair_law.hpp"
#include "math/error_free.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Why this impact is not one of a sphere and a plane alone; empty if it is.
std::string why_coupled(const State& state, const Key& key, const Flight& f, const Neighbourhood& neighbourhood)
{
    if (belongs_to_previous_instant(state, key))
        return several_contacts(pair_name(state, key.a, key.b), "another impact has just moved one of them");
    const BodyId other = other_closing(state, f, key.a, key.b, neighbourhood);
    if (other == no_body) return {};
    return several_contacts(pair_name(state, key.a, key.b), pair_name(state, key.a, other) + " touch");
}

}  // namespace

Resolution resolve_plane_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    Resolution out;
    const BodyId id = key.a;
    const int plane = state.plane_index(key.b);
    const Sphere& sphere = state.sphere(id);
    Flight f = advanced(state, id, key.time);
    out.unresolved = why_coupled(state, key, f, neighbourhood);
    if (!out.unresolved.empty()) return out;

    const ContactLaw& law = state.laws.plane(sphere.material, state.plane(plane).material);
    const Vec3 normal = facing_normal(state, plane, f.place);
    out.penetration = std::max(0.0, -height_above(state, id, plane, f.place));
    const double gravity = -normal.dot(state.accelerations[f.acceleration]);  // > 0 presses

    Event impact{EventKind::impact, {}, 0, id, key.b, normal, Vec3::Zero()};
    if (normal.dot(f.velocity) < 0) {
        const Vec3 change = velocity_change(f.velocity, normal, law);
        f.velocity += change;
        impact.impulse = (1 / state.inverse_mass(id)) * change;
    }
    out.events.push_back(impact);
    const SupportAfterImpact support = keep_to_support(state, f);
    if (support == SupportAfterImpact::released) out.events.push_back(release_event(state, id, state.flight(id)));
    if (support == SupportAfterImpact::pushed) {
        out.unresolved = several_contacts(
            pair_name(state, id, key.b),
            pair_name(state, id, state.scene.plane_body(static_cast<std::size_t>(f.support))) + " are in contact");
        return out;
    }
    double nudge = 4 * unit_roundoff * std::sqrt(f.velocity.squaredNorm());
    for (int i = 0; i < most_nudges && normal.dot(f.velocity) < 0; ++i, nudge *= 2) f.velocity += nudge * normal;

    const double w = normal.dot(f.velocity);
    const bool rests = is_rest(state.radius(id) + state.frame.cell_size, f.velocity, w, gravity);
    if (rests && f.support >= 0) {
        out.unresolved = state.scene.body_name(id) + " comes to rest on a second plane, " +
                         state.scene.body_name(key.b) + ": contact with several planes is not resolved yet";
        return out;
    }
    out.changes.push_back({id, f});
    Change& change = out.changes.front();
    if (rests) {
        settle(state, id, plane, change.flight);
        out.events.push_back({EventKind::rest, {}, 0, id, key.b, normal, Vec3::Zero()});
    } else if (f.support < 0 && is_low(state, id, w, gravity, law)) {
        out.series = make_series(state, f, plane, w, gravity, law);
        if (series_is_clear(state, id, f, plane, out.series, neighbourhood)) {
            change.flight.mode = Mode::series;
            change.flight.support = plane;
        }
    }
    return out;
}

}  // namespace carom
