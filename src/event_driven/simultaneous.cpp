#include "event_driven/simultaneous.hpp"

#include "event_driven/may_touch.hpp"
#include "event_driven/motion.hpp"
#include "math/length.hpp"
#include "toi/sphere_sphere.hpp"

#include <algorithm>

namespace carom {

namespace {

/// Is the contact closed at this instant, and not opening? (One that opens would have to be closed again by the same
/// instant to matter.) \pre a is a sphere; flights are of this instant.
bool closed_contact(const State& state, const Flight& a, BodyId id_a, const Flight& b, BodyId id_b)
{
    const double radius = std::min(state.radius(id_a), state.radius(id_b));
    const Vec3 r = separation(state.frame, a.place, b.place);
    const double sum = state.radius(id_a) + state.radius(id_b);
    const double reach = sum + std::max(state.rebound_gap, state.tie(radius));
    return r.squaredNorm() <= reach * reach && approach_sign(r, a.velocity - b.velocity) <= 0 &&
           state.ties(id_a, id_b, length(r) - sum, a.start);
}

bool closed_contact(const State& state, const Flight& a, BodyId id, int plane)
{
    const Plane& p = state.plane(plane);
    if (!p.thickness && p.normal.dot(a.velocity) > 0) return false;  // the cheap half of the answer first
    const BodyId b = state.scene.plane_body(static_cast<std::size_t>(plane));
    if (!state.ties(id, b, height_above(state, id, plane, a.place), a.start)) return false;
    return facing_normal(state, plane, a.place).dot(a.velocity) <= 0;
}

}  // namespace

bool ContactInstant::is_certifiable_contact(BodyId body, BodyId other) const
{
    return state_.is_plane(other) ? flies_freely(state_.flight(body)) : is_certifiable(state_, body, other);
}

Enclosure<DoubleDouble> ContactInstant::wait(BodyId body, BodyId other) const
{
    const Flown a = flown(state_, body, contact_.time);
    return state_.is_plane(other) ? plane_wait(state_, a, body, state_.plane_index(other))
                                  : pair_wait(state_, a, body, flown(state_, other, contact_.time), other);
}

bool ContactInstant::is_that_of(BodyId body, BodyId other) const
{
    if (!state_.certified() || !is_certifiable_contact(body, other) || !is_certifiable_contact(contact_.a, contact_.b))
        return true;
    const Enclosure<DoubleDouble> own = wait(contact_.a, contact_.b), its = wait(body, other);
    return !(its.t_hi < own.t_lo) && !(own.t_hi < its.t_lo);
}

bool other_closed(const State& state, const ContactInstant& instant, const Flight& now, BodyId body, BodyId partner,
                  const Neighbourhood& neighbourhood)
{
    if (now.mode == Mode::fixed) return false;  // contacts are linked through bodies that can move
    for (int p = 0; p < static_cast<int>(state.scene.planes.size()); ++p) {
        const BodyId plane = state.scene.plane_body(static_cast<std::size_t>(p));
        if (plane != partner && p != now.support && closed_contact(state, now, body, p) &&
            instant.is_that_of(body, plane))
            return true;
    }
    const double margin = std::max(state.rebound_gap, state.tie(state.radius(body)));
    for (const BodyId other : neighbourhood(body)) {
        if (other == partner) continue;
        if (!may_touch(state, body, now, other, margin)) continue;
        if (closed_contact(state, now, body, advanced(state, other, now.start), other) &&
            instant.is_that_of(body, other))
            return true;
    }
    return false;
}

bool belongs_to_previous_instant(const State& state, const Key& key)
{
    if (state.certified()) return false;  // there a contact that is closed was predicted from this very flight
    const bool with_plane = state.is_plane(key.b);
    const Flight& a = state.flight(key.a);
    const auto changed = [&](BodyId body) { return state.stamps[static_cast<std::size_t>(body)] > 0; };
    if (with_plane) {
        if (!changed(key.a) || recedes_at_start(state, a, state.plane_index(key.b))) return false;
        const PlaneMotion m = plane_motion(state, moving(state, key.a), state.plane_index(key.b));
        return m.h <= state.tie(state.radius(key.a)) && m.w < 0;
    }
    const Flight& b = state.flight(key.b);
    const BodyId later = a.start < b.start ? key.b : key.a;
    if (!changed(later)) return false;
    const PairMotion m = pair_motion(state, moving(state, key.a), moving(state, key.b));
    const double reach = m.contact_distance + state.tie(std::min(state.radius(key.a), state.radius(key.b)));
    return m.r.squaredNorm() <= reach * reach && approach_sign(m.r, m.v) < 0;
}

}  // namespace carom
