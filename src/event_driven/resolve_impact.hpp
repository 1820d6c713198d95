/// \file
/// The impact of one contact alone, see `resolve`.
#pragma once

#include "event_driven/resolve.hpp"
#include "event_driven/tolerances.hpp"
#include "motion/kinematics.hpp"

namespace carom {

/// Resolves the impact of a contact alone. \returns false if the event is not one of this contact alone but one for
/// resolve_component; then `out` is of no use
bool resolve_sphere_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out);
bool resolve_plane_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out);

/// The body's motion from here on if nothing happens to it: to be edited.
inline Change& add_change(const State& state, BodyId body, const EpochTime& now, EventOutcome& out)
{
    Change& change = out.changes.emplace_back();
    change.body = body;
    change.flight = flown(state, body, now);
    if (state.bodies.kind(body) != MotionKind::flying) change.motion = state.bodies.motion(body);
    return change;
}

/// The event of a body that is pulled off the plane on which it leaned.
inline Event release_event(const State& state, BodyId body)
{
    const int plane = state.bodies.as<Leaning>(body)->plane;
    return make_event(state, EventKind::release, body, Partner::plane(plane),
                      facing_normal(state, plane, state.flight(body).place));
}

}  // namespace carom
