/// \file
/// What an event does: flights in, flights out. Nothing is changed here; the loop commits.
#pragma once

#include "core/few.hpp"
#include "event_driven/state.hpp"
#include "queue/key.hpp"

#include <functional>
#include <span>
#include <vector>

namespace carom {

/// Every body that may touch this one now; valid until the next call.
using Neighbourhood = std::function<std::span<const BodyId>(BodyId)>;

struct Change {
    BodyId body = no_body;
    Flight flight;
    Vec3 low = Vec3::Zero();  ///< of its place, in certified runs: see State::low [length]
};

/// Outcome of one event.
struct Resolution {
    Few<Change, 2> changes;
    Series series;           ///< of the one change whose flight is a series, if any
    Few<Event, 3> events;    ///< times and hash are the loop's business: only kind, a, b, normal, impulse
    double penetration = 0;  ///< of the contact at the instant of impact, >= 0 [length]
    /// Not an event of one contact alone, and nothing of it has been carried out: see resolve_component.
    bool coupled = false;
};

/// Carry out the event `key`, whose participants have not changed since it was predicted.
Resolution resolve(const State& state, const Key& key, const Neighbourhood& neighbourhood);

/// The mode and support of each body as the scene starts: what touches a plane (gap within 1e-9 r), does not leave it
/// and is pressed on it rests or slides there. Returns only the bodies that do.
std::vector<Change> initial_contacts(const State& state);

}  // namespace carom
