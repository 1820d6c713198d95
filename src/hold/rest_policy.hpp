/// \file
/// What the rest policy makes of the law of an impact.
#pragma once

#include "gather/heap.hpp"

namespace carom {

/// The law of a contact that closes at this speed, > 0: policy micro makes slow ones elastic, so that what would rest
/// goes on in a train of bounces of a speed near v_c (after Hahn 1988).
inline ContactLaw law_of_impact(const State& state, ContactLaw law, double closing)
{
    if (state.scene.rest.policy == RestPolicy::micro && closing < state.rest.closing_speed) law.restitution = 1;
    return law;
}

/// Whether a contact with restitution below 1 closes slower than v_c, or closed less than tau_p ago: in a heap it has
/// no rebound then. \param closing speed, > 0 [length/time]
inline bool is_slow(const State& state, const ContactLaw& law, BodyId a, Partner b, double closing,
                    const EpochTime& now)
{
    return law.restitution < 1 && state.scene.rest.policy == RestPolicy::contact &&
           (closing < state.rest.closing_speed || state.recent.has(a, state.body_of(b), now));
}

/// Whether such a contact has no rebound: in a heap, where too many bounces are to come, or where rounding ends them.
/// A flight that lasts t and ends with speed c rises c t / 4. \param is_in_heap asked only if it matters
template <class IsInHeap>
bool is_inelastic(const State& state, const ContactLaw& law, BodyId a, Partner b, double closing, const EpochTime& now,
                  const IsInHeap& is_in_heap)
{
    if (!is_slow(state, law, a, b, closing, now)) return false;
    if (!bounces_end(law.restitution) || is_in_heap()) return true;
    const std::optional<double> flight = state.recent.since(a, state.body_of(b), now);
    return flight && closing * *flight <= 4 * state.lowest_bounce(state.smaller_radius(a, b));
}

}  // namespace carom
