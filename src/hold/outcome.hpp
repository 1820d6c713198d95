/// \file
/// What an event does: how its bodies go on, and what happened. Nothing is changed by making one; the loop commits it.
#pragma once

#include "motion/bodies.hpp"

#include <carom/simulate.hpp>

#include <vector>

namespace carom {

/// Forces of a body that rested and rests, in the same contacts.
struct ForceChange {
    BodyId body = no_body;
    std::vector<PersistentContact> contacts{};
};

/// Counts of an event beside its changes.
struct EventTally {
    EnergyTaken taken;
    std::int64_t numeric_steps = 0;
    bool clustered = false;  ///< impacts of several contacts were resolved together
    bool capped = false;     ///< see ClusterImpact
    bool dies_out = false;   ///< see LoneImpact
    std::optional<EarlyRest> early_rest;
    /// A body of the component that goes on in windows, which this event is for then; no_body if there is none.
    BodyId in_windows = no_body;
    double penetration = 0;  ///< of contacts at this instant, and of the parabolas of numeric pieces, >= 0 [length]
};

struct EventOutcome : EventTally {
    std::vector<Change> changes;      ///< bodies ascending, where there are several
    std::vector<ForceChange> forces;  ///< likewise
    std::vector<Event> events;        ///< kind, a, b, normal and impulse; times are the loop's business

    /// Nothing has happened; what was allocated stays for the next event.
    void clear()
    {
        changes.clear();
        forces.clear();
        events.clear();
        static_cast<EventTally&>(*this) = {};
    }
};

}  // namespace carom
