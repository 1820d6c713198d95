#include "event_driven/resolve_impact.hpp"

#include "gather/instant.hpp"
#include "hold/rest_policy.hpp"
#include "hold/support.hpp"
#include "impact/pair_law.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Whether this is more than an impact of two spheres alone, or one without a rebound, whose contact may persist.
bool is_coupled(const State& state, const Key& key, const ContactLaw& law, const Flight& a, const Flight& b,
                double closing, const Neighbourhood& neighbourhood)
{
    const ContactInstant instant(state, key);
    const BodyId other = key.b.index;
    return state.bodies.is_held_by_several(key.a) || state.bodies.is_held_by_several(other) || law.restitution == 0 ||
           is_inelastic(state, law, key.a, key.b, closing, key.time) || belongs_to_previous_instant(state, key) ||
           other_closed(state, instant, a, key.a, key.b, neighbourhood) ||
           other_closed(state, instant, b, other, Partner::sphere(key.a), neighbourhood);
}

}  // namespace

bool resolve_sphere_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out)
{
    const BodyId id_a = key.a, id_b = key.b.index;
    out.changes.reserve(2);
    Change& change_a = add_change(state, id_a, key.time, out);
    Change& change_b = add_change(state, id_b, key.time, out);
    Flight &a = change_a.flight, &b = change_b.flight;
    const Encounter encounter(state, a, id_a, &b, key.b);
    const Vec3& normal = encounter.normal();
    const double inverse_a = state.inverse_mass(id_a), inverse_b = state.inverse_mass(id_b);
    const ContactLaw& law = state.law(id_a, key.b);
    const double closing = -normal.dot(encounter.velocity());
    if (is_coupled(state, key, law, a, b, closing, neighbourhood)) return false;
    out.penetration = encounter.penetration();

    const double speeds = std::sqrt(a.velocity.squaredNorm()) + std::sqrt(b.velocity.squaredNorm());
    Vec3 impulse = Vec3::Zero();
    if (encounter.approach_sign() < 0) {
        const PairImpact after =
            resolve_pair({a.velocity, inverse_a}, {b.velocity, inverse_b}, normal, law_of_impact(state, law, closing));
        a.velocity = after.velocity_a;
        b.velocity = after.velocity_b;
        impulse = after.impulse;
    }
    out.events.push_back(make_event(state, EventKind::impact, id_a, key.b, normal, impulse));

    for (Change* const change : {&change_a, &change_b}) {
        const SupportAfterImpact support = keep_to_support(state, *change);
        if (support == SupportAfterImpact::released) out.events.push_back(release_event(state, change->body));
        if (support == SupportAfterImpact::pushed) return false;
    }
    const double reduced_mass = 1 / (inverse_a + inverse_b);
    // The kernel must not see the contact close again; rounding may say otherwise.
    double nudge = first_nudge * speeds;
    for (int i = 0; i < most_nudges && encounter.approach_sign() < 0; ++i, nudge *= 2) {
        a.velocity += (nudge * reduced_mass * inverse_a) * normal;
        b.velocity -= (nudge * reduced_mass * inverse_b) * normal;
    }
    std::erase_if(out.changes, [&](const Change& change) { return state.is_fixed(change.body); });
    return true;
}

}  // namespace carom
