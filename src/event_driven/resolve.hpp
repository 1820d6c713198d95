/// \file
/// What an event does: motions in, an outcome out. Nothing is changed here; the loop commits.
#pragma once

#include "gather/may_touch.hpp"
#include "hold/outcome.hpp"
#include "queue/key.hpp"

namespace carom {

/// An event between `a` and `b`; of two spheres the smaller id becomes the event's a.
/// \param normal from b to a \param impulse on a
Event make_event(const State& state, EventKind kind, BodyId a, Partner b, const Vec3& normal,
                 const Vec3& impulse = Vec3::Zero());

/// Carry out the event `key`, whose participants have not changed since it was predicted.
/// \param out empty
/// \returns whether it was an event of one contact alone, not of a component
bool resolve(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out);

/// Contacts that the scene declares: those that close have their impact at once, the others take hold.
std::vector<EventOutcome> begin_components(const State& state);

}  // namespace carom
