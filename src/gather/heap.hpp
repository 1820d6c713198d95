/// \file
/// Heaps: bodies that are many, and near each other. Thresholds of rest are for them; fewer bounce until rounding
/// (docs/impacts.md, section 4).
#pragma once

#include "gather/may_touch.hpp"

namespace carom {

/// Whether more than `largest_group` bodies are near `body` and each other, or one of them is in a piece of motion,
/// whose ends are all that is exact in it.
bool is_in_heap(const State& state, BodyId body, const EpochTime& now, const Neighbourhood& neighbourhood);

/// Whether heaps of the run go on in windows once they are hot (docs/windows.md). Windows know no drag, and calm by
/// gravity.
inline bool has_windows(const State& state)
{
    return state.loses_energy && !(state.drag > 0) && state.scene.guard.on &&
           state.scene.guard.fallback == GuardFallback::windows && state.scene.rest.policy == RestPolicy::contact &&
           state.bodies.accelerations().has_gravity();
}

/// Whether infinitely many bounces with this restitution, below 1, are few enough to be carried out until rounding.
inline bool bounces_end(double restitution)
{
    return bounces_of_rounding <= most_bounces * (1 - restitution);
}

}  // namespace carom
