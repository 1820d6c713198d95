/// \file
/// Events of bodies in several contacts: impacts resolved together, contacts that persist, ends of numeric steps and of
/// windows of the guard.
#pragma once

#include "event_driven/resolve.hpp"

namespace carom {

/// Carry out the event `key` for all bodies that contacts connect with its own. \param out empty
void resolve_component(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out);

}  // namespace carom
