/// \file
/// Heaps that are hot or large go on in windows (docs/windows.md): from events to problems of windows, and back.
#pragma once

#include "gather/may_touch.hpp"
#include "hold/outcome.hpp"

namespace carom {

/// Whether the body is in a window of a heap, or at rest in a heap that landed: events with it are for `heap_windows`.
bool is_in_windows(const State& state, BodyId body);

struct HeapEvent {
    std::vector<BodyId> bodies;  ///< of the event
    bool accumulates = false;    ///< too many impacts: a window must be taken, also by few bodies
};

/// One window more for all bodies that are connected with those of the event, for each connected part of them: straight
/// motions that cannot overlap, exact rest where it is near. Parts that are no heap fly on.
/// \param wide every sphere whose surface may be up to the largest diameter away
EventOutcome heap_windows(const State& state, const HeapEvent& event, const EpochTime& now, const Neighbourhood& wide);

}  // namespace carom
