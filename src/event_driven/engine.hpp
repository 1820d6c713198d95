/// \file
/// The exact-contact simulation: between contacts closed-form flights, the next contact a root, the order of contacts a
/// queue.
#pragma once

#include <carom/simulate.hpp>

namespace carom {

/// A run of a scene. No impact is lost and none invented (within double precision of the flights), no pair sinks beyond
/// rounding, and the run always ends with a status. \pre the scene is valid
Outcome run_event_driven(const Scene& scene, const EventDriven& method, const RunOptions& options,
                         const Observer& observer);

}  // namespace carom
