#include "event_driven/certified_motion.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/resolve_component.hpp"
#include "event_driven/resolve_impact.hpp"
#include "event_driven/simultaneous.hpp"
#include "event_driven/support.hpp"
#include "impact/pair_law.hpp"
#include "math/error_free.hpp"
#include "toi/sphere_sphere.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Not approaching, and accelerated towards each other: contact that persists, or is closed again at once.
bool is_pressed(const State& state, const Flight& a, const Flight& b, const Vec3& normal, double distance)
{
    if (a.acceleration == b.acceleration) return false;
    const Vec3 w = a.velocity - b.velocity, across = w - w.dot(normal) * normal;
    return normal.dot(state.accelerations[a.acceleration] - state.accelerations[b.acceleration]) +
               across.squaredNorm() / distance <
           0;
}

/// No rebound: the contact may persist.
bool stays(const State& state, const Key& key, const ContactLaw& law, const Flight& a, const Flight& b,
           const Vec3& normal)
{
    return law.restitution == 0 ||
           is_inelastic(state, law, key.a, key.b, -normal.dot(a.velocity - b.velocity), key.time);
}

/// Is this more than an impact of two spheres alone, or less: one without a rebound?
bool is_coupled(const State& state, const Key& key, const ContactLaw& law, const Flight& a, const Flight& b,
                const Vec3& normal, const Neighbourhood& neighbourhood)
{
    const ContactInstant instant(state, key);
    return a.support == several_supports || b.support == several_supports || stays(state, key, law, a, b, normal) ||
           belongs_to_previous_instant(state, key) || other_closed(state, instant, a, key.a, key.b, neighbourhood) ||
           other_closed(state, instant, b, key.b, key.a, neighbourhood);
}

}  // namespace

Resolution resolve_sphere_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    Resolution out;
    Flown now_a = flown(state, key.a, key.time), now_b = flown(state, key.b, key.time);
    Flight &a = now_a.flight, &b = now_b.flight;
    const bool certified = state.certified() && is_certifiable(state, key.a, key.b);
    const Sphere &sa = state.sphere(key.a), &sb = state.sphere(key.b);
    const double inverse_a = state.inverse_mass(key.a), inverse_b = state.inverse_mass(key.b);
    const Vec3 r = separation(state.frame, a.place, b.place);
    const double distance = std::sqrt(r.squaredNorm());
    const Vec3 normal = r / distance;
    const ContactLaw& law = state.law(key.a, key.b);
    out.coupled = is_coupled(state, key, law, a, b, normal, neighbourhood);
    if (out.coupled) return out;
    out.penetration = certified ? certified_penetration(state, now_a, key.a, now_b, key.b)
                                : std::max(0.0, sa.radius + sb.radius - distance);
    const auto approach = [&] {
        return certified ? exact_approach_sign(state, now_a, now_b) : approach_sign(r, a.velocity - b.velocity);
    };

    const double speeds = std::sqrt(a.velocity.squaredNorm()) + std::sqrt(b.velocity.squaredNorm());
    Event impact{EventKind::impact, {}, 0, key.a, key.b, normal, Vec3::Zero()};
    if (approach() < 0) {
        const PairImpact after = resolve_pair({a.velocity, inverse_a}, {b.velocity, inverse_b}, normal,
                                              law_of_impact(state, law, -normal.dot(a.velocity - b.velocity)));
        a.velocity = after.velocity_a;
        b.velocity = after.velocity_b;
        impact.impulse = after.impulse;
    } else if (is_pressed(state, a, b, normal, distance)) {
        return coupled();
    }
    out.events.push_back(impact);

    for (const auto& [body, flight] : {std::pair{key.a, &a}, std::pair{key.b, &b}}) {
        const SupportAfterImpact support = keep_to_support(state, *flight);
        if (support == SupportAfterImpact::released)
            out.events.push_back(release_event(state, body, state.flight(body)));
        if (support == SupportAfterImpact::pushed) return coupled();
    }
    const double reduced_mass = 1 / (inverse_a + inverse_b);
    double nudge = 4 * unit_roundoff * speeds;
    for (int i = 0; i < most_nudges && approach() < 0; ++i, nudge *= 2) {
        a.velocity += (nudge * reduced_mass * inverse_a) * normal;
        b.velocity -= (nudge * reduced_mass * inverse_b) * normal;
    }
    if (inverse_a > 0) out.changes.push_back({key.a, a, now_a.low});
    if (inverse_b > 0) out.changes.push_back({key.b, b, now_b.low});
    return out;
}

}  // namespace carom
