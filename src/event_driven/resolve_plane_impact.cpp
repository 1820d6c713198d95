#include "event_driven/low_bounce.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/resolve_component.hpp"
#include "event_driven/resolve_impact.hpp"
#include "event_driven/simultaneous.hpp"
#include "event_driven/support.hpp"
#include "impact/pair_law.hpp"
#include "math/error_free.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Is this more than an impact of a sphere and a plane alone, or less: one without a rebound? (Where gravity presses,
/// low bounces are summed instead, or go on until rounding ends them.)
bool is_coupled(const State& state, const Key& key, const ContactLaw& law, const Flight& f, const Vec3& normal,
                const Neighbourhood& neighbourhood)
{
    const auto pressed = [&] { return normal.dot(state.accelerations[f.acceleration]) < 0; };
    return f.support == several_supports ||
           (is_inelastic(state, law, key.a, key.b, -normal.dot(f.velocity), key.time) && !pressed()) ||
           belongs_to_previous_instant(state, key) ||
           other_closed(state, ContactInstant(state, key), f, key.a, key.b, neighbourhood);
}

}  // namespace

Resolution resolve_plane_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    Resolution out;
    const BodyId id = key.a;
    const int plane = state.plane_index(key.b);
    Flown now = flown(state, id, key.time);
    Flight& f = now.flight;
    const bool certified = state.certified() && flies_freely(f);
    const Vec3 normal = facing_normal(state, plane, f.place);
    const ContactLaw& plain = state.law(id, key.b);
    out.coupled = is_coupled(state, key, plain, f, normal, neighbourhood);
    if (out.coupled) return out;

    const ContactLaw law = law_of_impact(state, plain, -normal.dot(f.velocity));
    out.penetration = certified ? certified_penetration(state, now, id, plane)
                                : std::max(0.0, -height_above(state, id, plane, f.place));
    const auto approaches = [&] {
        return certified ? exact_plane_sign(normal, f.velocity) < 0 : normal.dot(f.velocity) < 0;
    };

    Event impact{EventKind::impact, {}, 0, id, key.b, normal, Vec3::Zero()};
    if (approaches()) {
        const Vec3 change = velocity_change(f.velocity, normal, law);
        f.velocity += change;
        impact.impulse = (1 / state.inverse_mass(id)) * change;
    }
    out.events.push_back(impact);
    const SupportAfterImpact support = keep_to_support(state, f);
    if (support == SupportAfterImpact::released) out.events.push_back(release_event(state, id, state.flight(id)));
    if (support == SupportAfterImpact::pushed) return coupled();
    const double gravity = -normal.dot(state.accelerations[f.acceleration]);  // > 0 presses, as it goes on
    double nudge = 4 * unit_roundoff * std::sqrt(f.velocity.squaredNorm());
    for (int i = 0; i < most_nudges && approaches(); ++i, nudge *= 2) f.velocity += nudge * normal;

    const double w = normal.dot(f.velocity);
    const bool rests = is_rest(state.radius(id) + state.frame.cell_size, f.velocity, w, gravity);
    if (rests && f.support >= 0) return coupled();
    out.changes.push_back({id, f, now.low});
    Change& change = out.changes.front();
    if (rests) {
        settle(state, id, plane, change.flight);
        change.low.setZero();
        out.events.push_back({EventKind::rest, {}, 0, id, key.b, normal, Vec3::Zero()});
    } else if (f.support < 0 && is_low(state, id, w, gravity, law)) {
        out.series = make_series(state, f, plane, w, gravity, law);
        if (series_is_clear(state, id, f, plane, out.series, neighbourhood)) {
            change.flight.mode = Mode::series;
            change.low.setZero();
            change.flight.support = plane;
        }
    }
    return out;
}

}  // namespace carom
