/// \file
/// The discrete methods: step in time and look for overlaps, to be compared with the event-driven engine.
///
/// Common to all: the motion between contacts (Integrator) with h = dt / substeps; ceil(until / dt) steps, the last one
/// shortened so that the run ends exactly at `until`; step k begins at k dt (nothing accumulates). Contacts do
/// not depend on how pairs are found: all pairs for few spheres, a cell grid for many, the same bits.
#pragma once

#include <carom/method.hpp>
#include <carom/simulate.hpp>

namespace carom {

/// One entry for each discrete alternative of Method. \pre the scene is valid. Outcome: `counts.steps` are substeps,
/// `max_events` bounds them; `max_penetration` is taken at the end of each substep, before correction; rest_times stay
/// empty and event_hash 0. Options out of range give Status::unresolved with a message, a position that is no longer
/// finite too.
Outcome run_stepping(const Scene& scene, const PositionBased& method, const RunOptions& options,
                     const Observer& observer);
Outcome run_stepping(const Scene& scene, const VelocityBased& method, const RunOptions& options,
                     const Observer& observer);
/// `passes` has no meaning here. Events carry the time of contact inside the substep.
Outcome run_stepping(const Scene& scene, const Bisection& method, const RunOptions& options, const Observer& observer);
/// `passes` has no meaning here: the response flips velocities whenever it is applied, so twice would be never.
Outcome run_stepping(const Scene& scene, const Naive& method, const RunOptions& options, const Observer& observer);
/// `passes` has no meaning here: contacts are solved together, to convergence or `sweeps`.
Outcome run_stepping(const Scene& scene, const Moreau& method, const RunOptions& options, const Observer& observer);
/// `passes` has no meaning here. Events carry the time of contact inside the substep; contacts that rest are none.
Outcome run_stepping(const Scene& scene, const ImpactSubsteps& method, const RunOptions& options,
                     const Observer& observer);
/// Neither `passes` nor `order` has a meaning here. An event is the begin of a contact, with the impulse of its first
/// substep; `plane_impulses` have all. A stiffness whose springs would gain energy is refused: Status::unresolved.
Outcome run_stepping(const Scene& scene, const Penalty& method, const RunOptions& options, const Observer& observer);
/// `passes` has no meaning here. Events carry the end of the substep in which bodies met.
Outcome run_stepping(const Scene& scene, const Speculative& method, const RunOptions& options,
                     const Observer& observer);
/// `passes` has no meaning here. Events carry the end of the step, `dt`, in which bodies met.
Outcome run_stepping(const Scene& scene, const Soft& method, const RunOptions& options, const Observer& observer);

}  // namespace carom
