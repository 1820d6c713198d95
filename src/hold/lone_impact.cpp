#include "hold/lone_impact.hpp"

#include "gather/instant.hpp"
#include "hold/rest_policy.hpp"
#include "hold/tolerances.hpp"
#include "math/length.hpp"

namespace carom {

namespace {

/// The acceleration with which the spheres are pressed together, < 0 where they come apart [length/time^2].
double pressing(const State& state, const Key& key, const Flight& a, const Flight& b, const SphereEncounter& encounter)
{
    const Vec3 &normal = encounter.normal(), v = encounter.velocity(), across = v - normal.dot(v) * normal;
    return normal.dot(state.acceleration(b) - state.acceleration(a)) -
           across.squaredNorm() / (state.radius(key.a) + state.radius(key.b.index));
}

/// The speed that rounding makes of none: of velocities, and of the time for which they are accelerated.
double speed_rounding(const State& state, const Flight& a, const Flight& b)
{
    return normal_speed_rounding * (length(a.velocity) + length(b.velocity)) +
           time_resolution * state.frame.epoch_length * length(state.gravity());
}

}  // namespace

LoneImpact lone_impact(const State& state, const Key& key, const Flight& a, const Flight& b,
                       const SphereEncounter& encounter, bool returns, const Neighbourhood& neighbourhood)
{
    const BodyId other = key.b.index;
    const double closing = -encounter.normal().dot(encounter.velocity());
    if (!bounces_to_rounding(state, key.a, other)) return {};
    const ContactLaw& law = state.law(key.a, key.b);
    const bool slow = is_slow(state, law, key.a, key.b, closing, key.time);
    if (!(slow || returns) || !is_apart(state, a, key.a, key.b, neighbourhood) ||
        !is_apart(state, b, other, Partner::sphere(key.a), neighbourhood))
        return {};
    const double press = pressing(state, key, a, b, encounter), loss = 1 - law.restitution,
                 rebound = law.restitution * closing;
    if (!(press > 0)) return {.rebounds = true};
    if (bounces_of_rounding > most_bounces * loss)
        return slow ? LoneImpact{.early = 2 * rebound / (press * loss)} : LoneImpact{};
    // Roundings of all bounces before, each of them multiplied by e since.
    if (rebound * loss <= speed_rounding(state, a, b)) return {};
    return {.rebounds = true, .dies_out = returns};
}

}  // namespace carom
