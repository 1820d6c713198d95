#include "event_driven/resolve_impact.hpp"

#include "gather/instant.hpp"
#include "hold/low_bounce.hpp"
#include "hold/rest_policy.hpp"
#include "hold/support.hpp"
#include "impact/pair_law.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Whether this is more than an impact of a sphere and a plane alone, or one without a rebound. (If gravity presses,
/// low bounces are summed instead, or go on until rounding ends them.)
bool is_coupled(const State& state, const Key& key, const ContactLaw& law, const Flight& f, const Vec3& normal,
                const Neighbourhood& neighbourhood)
{
    const ContactInstant instant(state, key, neighbourhood);
    const auto is_in_heap = [&] { return instant.is_in_heap(); };
    const auto pressed = [&] { return normal.dot(state.acceleration(f)) < 0; };
    return state.bodies.is_held_by_several(key.a) ||
           (is_inelastic(state, law, key.a, key.b, -normal.dot(f.velocity), key.time, is_in_heap) && !pressed()) ||
           belongs_to_previous_instant(state, key) || other_closed(state, instant, f, key.a, key.b, neighbourhood);
}

/// Brings a sphere to rest whose bounces are below the rounding of its place. Under drag, where no closed sum has taken
/// them all before, infinitely many are left: where they take of the tangential speed they take all of it.
void rest(const State& state, const Key& key, const Vec3& normal, const ContactLaw& law, Change& change,
          EventOutcome& out)
{
    settle(state, key.b.index, change);
    Vec3 impulse = Vec3::Zero();
    if (state.drag > 0 && law.restitution > 0 && law.tangential < 1) {
        impulse = -state.sphere(key.a).mass * change.flight.velocity;
        change.flight.velocity = Vec3::Zero();
        lean(state, key.b.index, change);
    }
    out.events.push_back(make_event(state, EventKind::rest, key.a, key.b, normal, impulse));
}

/// Brings a sphere to rest that leaves its plane slower than a threshold, with more than a million bounces to come.
void rest_early(const State& state, const Key& key, const Vec3& normal, double w, double time, Change& change,
                EventOutcome& out)
{
    settle(state, key.b.index, change);
    out.events.push_back(
        make_event(state, EventKind::settle, key.a, key.b, normal, -w * state.sphere(key.a).mass * normal));
    out.events.push_back(make_event(state, EventKind::rest, key.a, key.b, normal));
    out.early_rest = {key.a, time};
    out.taken.settling += state.sphere(key.a).mass * w * w / 2;
}

}  // namespace

bool resolve_plane_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out)
{
    const BodyId id = key.a;
    const int plane = key.b.index;
    Change& change = add_change(state, id, key.time, out);
    Flight& f = change.flight;
    const Vec3 normal = facing_normal(state, plane, f.place);
    const ContactLaw& plain = state.law(id, key.b);
    if (is_coupled(state, key, plain, f, normal, neighbourhood)) return false;

    const ContactLaw law = law_of_impact(state, plain, -normal.dot(f.velocity));
    out.penetration = penetration(state, f, id, plane);

    Vec3 impulse = Vec3::Zero();
    if (approach_sign(state, f, id, plane) < 0) {
        const Vec3 gained = velocity_change(f.velocity, normal, law);
        f.velocity += gained;
        impulse = (1 / state.inverse_mass(id)) * gained;
    }
    out.events.push_back(make_event(state, EventKind::impact, id, key.b, normal, impulse));
    const SupportAfterImpact support = keep_to_support(state, change);
    if (support == SupportAfterImpact::released) out.events.push_back(release_event(state, id));
    if (support == SupportAfterImpact::pushed) return false;
    const double gravity = -normal.dot(state.acceleration(f));  // > 0 presses, as it goes on
    // The kernel must not see the contact close again; rounding may say otherwise.
    double nudge = first_nudge * std::sqrt(f.velocity.squaredNorm());
    for (int i = 0; i < most_nudges && approach_sign(state, f, id, plane) < 0; ++i, nudge *= 2)
        f.velocity += nudge * normal;

    const double w = normal.dot(f.velocity);
    const bool leans = kind_of(change.motion) == MotionKind::leaning;
    if (is_rest(state.radius(id) + state.frame.cell_size, f.velocity, w, gravity)) {
        if (leans) return false;
        rest(state, key, normal, law, change, out);
    } else if (!leans && is_low(state, id, w, gravity, law)) {
        if (state.drag > 0) {
            const DampedBounces bounces = damped_bounces(state, key, f, w, gravity, law, neighbourhood);
            out.dies_out = bounces.die_out;
            if (bounces.early) rest_early(state, key, normal, w, *bounces.early, change, out);
            return true;
        }
        const Bouncing bouncing{plane, make_series(state, f, plane, w, gravity, law)};
        if (series_is_clear(state, id, f, bouncing, neighbourhood)) {
            std::fill_n(f.place.low, 3, 0.0);
            change.motion = bouncing;
        }
    }
    return true;
}

}  // namespace carom
