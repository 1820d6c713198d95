/// \file
/// The guard: where impacts accumulate, a discrete method carries the bodies concerned over one window.
#pragma once

#include "gather/component.hpp"
#include "hold/outcome.hpp"

namespace carom {

/// All bodies nearly in contact with `body` and each other go straight on for one window (rest.numeric_step unless
/// guard.window is set), at the velocities that the fallback of the scene gives them:
///
/// - moreau: one step of Moreau and Jean's scheme with e = 0, the velocities nearest to v + h g (in the metric of
///   kinetic energy) with c + gap/h >= 0 for all contacts that could close (Moreau 1988). Since the gap of a straight
///   motion is never below its linear prediction, nothing overlaps that did not before, up to rounding.
/// - velocity, pbd: one step of these methods, with all that they do about overlaps or do not.
EventOutcome guard(const State& state, BodyId body, const EpochTime& now, const Neighbourhood& neighbourhood);

/// The bodies that it would take over, or `enough` of them.
std::vector<BodyId> guarded_bodies(const State& state, BodyId body, const EpochTime& now,
                                   const Neighbourhood& neighbourhood, std::size_t enough);

}  // namespace carom
