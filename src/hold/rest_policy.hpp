/// \file
/// What the rest policy makes of the law of an impact.
#pragma once

#include "motion/state.hpp"

namespace carom {

/// The law of a contact that closes at this speed, > 0: policy micro makes slow ones elastic, so that what would rest
/// goes on in a train of bounces of a speed near v_c (after Hahn 1988).
inline ContactLaw law_of_impact(const State& state, ContactLaw law, double closing)
{
    if (state.scene.rest.policy == RestPolicy::micro && closing < state.rest.closing_speed) law.restitution = 1;
    return law;
}

/// Must a contact with restitution below 1 be inelastic: because it closes slower than v_c, or closed less than tau_p
/// ago? \param closing speed, > 0 [length/time]
inline bool is_inelastic(const State& state, const ContactLaw& law, BodyId a, Partner b, double closing,
                         const EpochTime& now)
{
    return law.restitution < 1 && state.scene.rest.policy == RestPolicy::contact &&
           (closing < state.rest.closing_speed || state.recent.has(a, state.body_of(b), now));
}

}  // namespace carom
