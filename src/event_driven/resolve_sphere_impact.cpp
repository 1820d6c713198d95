#include "event_driven/resolve_impact.hpp"

#include "gather/instant.hpp"
#include "hold/lone_impact.hpp"
#include "hold/rest_policy.hpp"
#include "hold/support.hpp"
#include "impact/pair_law.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Whether this is more than an impact of two spheres alone, or one without a rebound, whose contact may persist.
bool is_coupled(const State& state, const Key& key, const ContactLaw& law, const Flight& a, const Flight& b,
                double closing, bool rebounds, const Neighbourhood& neighbourhood)
{
    const ContactInstant instant(state, key, neighbourhood);
    const BodyId other = key.b.index;
    return state.bodies.is_held_by_several(key.a) || state.bodies.is_held_by_several(other) || law.restitution == 0 ||
           (!rebounds &&
            is_inelastic(state, law, key.a, key.b, closing, key.time, [&] { return instant.is_in_heap(); })) ||
           belongs_to_previous_instant(state, key) || other_closed(state, instant, a, key.a, key.b, neighbourhood) ||
           other_closed(state, instant, b, other, Partner::sphere(key.a), neighbourhood);
}

/// Whether a sphere returns to the fixed one that it has just left.
bool is_low_return(const State& state, const Key& key)
{
    const BodyId other = key.b.index;
    return (state.is_fixed(key.a) || state.is_fixed(other)) &&
           low_return(state, key.a, other, lawful_pair_motion(state, key.a, other));
}

/// Puts such a sphere into contact again, for the time of its next return does not mend the rounding of its place. (In
/// certified runs there is none. Coordinates along which it does not move keep their bits.)
void put_in_contact(const State& state, Change& a, Change& b, const SphereEncounter& encounter)
{
    const bool a_is_fixed = state.is_fixed(a.body);
    Change& sphere = a_is_fixed ? b : a;
    const Flight& before = state.flight(sphere.body);
    Vec3 way = (a_is_fixed ? encounter.gap() : -encounter.gap()) * encounter.normal();
    for (int k = 0; k < 3; ++k)
        if (before.velocity[k] == 0 && state.acceleration(before)[k] == 0) way[k] = 0;
    Place& place = sphere.flight.place;
    place = moved(state.frame, place, way);
}

}  // namespace

bool resolve_sphere_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out)
{
    const BodyId id_a = key.a, id_b = key.b.index;
    out.changes.reserve(2);
    Change& change_a = add_change(state, id_a, key.time, out);
    Change& change_b = add_change(state, id_b, key.time, out);
    Flight &a = change_a.flight, &b = change_b.flight;
    const SphereEncounter encounter(state, a, id_a, b, id_b);
    const Vec3& normal = encounter.normal();
    const double inverse_a = state.inverse_mass(id_a), inverse_b = state.inverse_mass(id_b);
    const ContactLaw& law = state.law(id_a, key.b);
    const double closing = -normal.dot(encounter.velocity());
    const bool loses = law.restitution < 1, returns = loses && is_low_return(state, key);
    const LoneImpact lone = loses ? lone_impact(state, key, a, b, encounter, returns, neighbourhood) : LoneImpact{};
    if (lone.early) out.early_rest = {state.is_fixed(id_a) ? id_b : id_a, *lone.early};
    if (is_coupled(state, key, law, a, b, closing, lone.rebounds, neighbourhood)) return false;
    out.dies_out = lone.dies_out;
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
    if (returns && !state.certified()) put_in_contact(state, change_a, change_b, encounter);
    std::erase_if(out.changes, [&](const Change& change) { return state.is_fixed(change.body); });
    return true;
}

}  // namespace carom
