/// \file
/// The earliest event of a body that no other sphere has a part in: a plane, the end of its series or of its piece.
#pragma once

#include "motion/kinematics.hpp"
#include "queue/key.hpp"

namespace carom {

/// The event with which a body's motion ends by itself; its time is `never` if it does not.
inline Key own_end(const State& state, BodyId body)
{
    const EpochTime time = end_of(state.bodies.motion(body), state.frame, state.flight(body).start);
    if (const auto* bouncing = state.bodies.as<Bouncing>(body))
        return {time, Scheduled::series_end, body, Partner::plane(bouncing->plane)};
    return {time, Scheduled::piece_end, body, {}};
}

/// Offers to `take(key, rough)` each event of `body` with itself and with planes, in no particular order. Planes that
/// carry the body are left out, and so may be what comes after `best`, the time of the best one so far. \param
/// is_out_of_reach whether a plane certainly need not be looked at
template <class Kinematics, class Take, class OutOfReach>
void offer_planes(const State& state, BodyId body, Counts& counts, const EpochTime& best, const Take& take,
                  const OutOfReach& is_out_of_reach)
{
    const MotionKind kind = state.bodies.kind(body);
    const bool bounces = kind == MotionKind::bouncing;
    std::optional<int> carrier;
    if (kind != MotionKind::flying) {
        carrier = carrier_of(state.bodies.motion(body));
        if (const Key end = own_end(state, body); end.time != never) take(end, false);
    }
    if (state.bodies.is_in_heap_window(body)) return;  // it reaches no plane
    const bool several = state.bodies.is_held_by_several(body);
    const Moving sphere = moving(state, body);
    counts.pair_tests += state.planes();
    for (int p = 0; p < state.planes(); ++p) {
        if (is_out_of_reach(p)) continue;
        const Partner plane = Partner::plane(p);
        if (carrier == p || (several && state.bodies.contacts().between(body, plane))) continue;
        const ContactTime contact = Kinematics::plane_time(state, sphere, p, best);
        if (!contact.comes) continue;
        ++counts.root_solves;
        take({contact.time, bounces ? Scheduled::intrusion : Scheduled::plane_impact, body, plane}, contact.rough);
    }
}

}  // namespace carom
