#include "gather/instant.hpp"

#include "math/length.hpp"

#include <algorithm>

namespace carom {

namespace {

/// Whether the contact is closed at this instant and not opening. (One that opens would have to be closed again by the
/// same instant to matter.) \pre a is a sphere; flights are of this instant.
Closed closed_contact(const State& state, const ContactInstant& instant, const Flight& a, BodyId id_a, const Flight& b,
                      BodyId id_b)
{
    const Partner partner = Partner::sphere(id_b);
    const Vec3 r = separation(state.frame, a.place, b.place);
    const double sum = state.radius(id_a) + state.radius(id_b);
    const double reach = sum + std::max(state.rebound_gap, state.tie(state.smaller_radius(id_a, partner)));
    if (r.squaredNorm() > reach * reach || approach_sign(r, a.velocity - b.velocity) > 0) return Closed::no;
    return instant.closed(id_a, partner, length(r) - sum);
}

Closed closed_contact(const State& state, const ContactInstant& instant, const Flight& a, BodyId id, int plane)
{
    const Plane& p = state.plane(plane);
    if (!p.thickness && p.normal.dot(a.velocity) > 0) return Closed::no;  // the cheap half of the answer first
    const Closed closed = instant.closed(id, Partner::plane(plane), height_above(state, id, plane, a.place));
    if (closed == Closed::no || facing_normal(state, plane, a.place).dot(a.velocity) <= 0) return closed;
    return Closed::no;
}

}  // namespace

Enclosure<DoubleDouble> ContactInstant::wait_for(BodyId body, Partner other) const
{
    const Flight a = flown(state_, body, contact_.time);
    if (other.is_plane()) return wait(state_, a, body, other.index);
    return wait(state_, a, body, flown(state_, other.index, contact_.time), other.index);
}

bool ContactInstant::is_that_of(BodyId body, Partner other) const
{
    if (!is_certified_gap(state_, body, other) || !is_certified_gap(state_, contact_.a, contact_.b)) return true;
    const Enclosure<DoubleDouble> own = wait_for(contact_.a, contact_.b), its = wait_for(body, other);
    return !(its.t_hi < own.t_lo) && !(own.t_hi < its.t_lo);
}

bool ContactInstant::is_in_heap() const
{
    if (!heap_) {
        const BodyId body = state_.is_fixed(contact_.a) ? contact_.b.index : contact_.a;
        heap_ = carom::is_in_heap(state_, body, contact_.time, neighbourhood_);
    }
    return *heap_;
}

Closed ContactInstant::closed(BodyId a, Partner b, double gap) const
{
    const double radius = state_.smaller_radius(a, b), tie = state_.tie(radius);
    if (!(gap <= std::max(tie, state_.rebound_gap))) return Closed::no;
    if (!(state_.rebound_gap > 0) || !state_.recent.has(a, state_.body_of(b), contact_.time))
        return gap <= tie ? Closed::yes : Closed::no;
    return gap <= std::min(tie, state_.lowest_bounce(radius)) ? Closed::yes : Closed::in_heaps;
}

bool other_closed(const State& state, const ContactInstant& instant, const Flight& now, BodyId body, Partner partner,
                  const Neighbourhood& neighbourhood)
{
    if (state.is_fixed(body)) return false;  // contacts are linked through bodies that can move
    if (neighbourhood.is_alone(body, partner, now.start)) return false;
    const auto* leaning = state.bodies.as<Leaning>(body);
    bool in_heaps = false;
    const auto is_closed = [&](Closed closed, Partner other) {
        if (closed == Closed::no || !instant.is_that_of(body, other)) return false;
        in_heaps = in_heaps || closed == Closed::in_heaps;
        return closed == Closed::yes;
    };
    for (int p = 0; p < state.planes(); ++p) {
        const Partner plane = Partner::plane(p);
        if (plane != partner && !(leaning && p == leaning->plane) &&
            is_closed(closed_contact(state, instant, now, body, p), plane))
            return true;
    }
    const double margin = state.widest_tie(body);
    for (const BodyId other : neighbourhood(body)) {
        if (partner == Partner::sphere(other)) continue;
        if (!may_touch(state, body, now, other, margin)) continue;
        if (is_closed(closed_contact(state, instant, now, body, advanced(state, other, now.start), other),
                      Partner::sphere(other)))
            return true;
    }
    return in_heaps && instant.is_in_heap();
}

bool is_apart(const State& state, const Flight& now, BodyId body, Partner partner, const Neighbourhood& neighbourhood)
{
    if (state.is_fixed(body)) return true;
    if (state.bodies.kind(body) != MotionKind::flying) return false;
    const double margin = near_contact * state.radius(body);
    for (int p = 0; p < state.planes(); ++p)
        if (height_above(state, body, p, now.place) <= margin) return false;
    for (const BodyId other : neighbourhood(body)) {
        if (partner == Partner::sphere(other) || !may_touch(state, body, now, other, margin)) continue;
        const Flight its = advanced(state, other, now.start);
        const double reach = state.radius(body) + state.radius(other) + margin;
        if (separation(state.frame, now.place, its.place).squaredNorm() <= reach * reach) return false;
    }
    return true;
}

bool belongs_to_previous_instant(const State& state, const Key& key)
{
    if (state.certified()) return false;  // there a contact that is closed was predicted from this very flight
    const auto changed = [&](BodyId body) { return state.bodies.stamp(body) > 0; };
    const double tie = state.tie(state.smaller_radius(key.a, key.b));
    const Flight& a = state.flight(key.a);
    if (key.b.is_plane()) {
        if (!changed(key.a) || recedes_at_start(state, a, key.b.index)) return false;
        const PlaneMotion m = plane_motion(state, moving(state, key.a), key.b.index);
        return m.h <= tie && m.w < 0;
    }
    if (!changed(a.start < state.flight(key.b.index).start ? key.b.index : key.a)) return false;
    const PairMotion m = lawful_pair_motion(state, key.a, key.b.index);
    const double reach = m.contact_distance + tie;
    return m.r.squaredNorm() <= reach * reach && approach_sign(m.r, m.v) < 0;
}

}  // namespace carom
