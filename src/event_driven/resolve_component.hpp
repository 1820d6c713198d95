/// \file
/// Events of bodies in several contacts: impacts resolved together, contacts that persist, ends of numeric steps and of
/// windows of the guard.
#pragma once

#include "event_driven/hold_component.hpp"

namespace carom {

struct ComponentResolution {
    std::vector<MemberChange> changes;
    std::vector<Event> events;
    EnergyTaken taken;
    std::int64_t numeric_steps = 0;
    bool clustered = false;  ///< impacts of several contacts were resolved together
    bool capped = false;     ///< see ClusterImpact
    double penetration = 0;  ///< of contacts at this instant, and of the parabolas of numeric pieces, >= 0 [length]
};

/// Carry out the event `key` for all bodies that contacts connect with its own.
ComponentResolution resolve_component(const State& state, const Key& key, const Neighbourhood& neighbourhood);

/// Contacts that the scene declares: those that close have their impact at once, the others take hold.
std::vector<ComponentResolution> begin_components(const State& state);

/// The law of a contact that closes at this speed, > 0: policy micro makes slow ones elastic, so that what would rest
/// goes on in a train of bounces of a speed near v_c (after Hahn 1988).
inline ContactLaw law_of_impact(const State& state, ContactLaw law, double closing)
{
    if (state.scene.rest.policy == RestPolicy::micro && closing < state.rest.closing_speed) law.restitution = 1;
    return law;
}

/// Must a contact with restitution below 1 be inelastic: because it closes slower than v_c, or closed less than tau_p
/// ago? \param closing speed, > 0 [length/time]
inline bool is_inelastic(const State& state, const ContactLaw& law, BodyId a, BodyId b, double closing,
                         const EpochTime& now)
{
    return law.restitution < 1 && state.scene.rest.policy == RestPolicy::contact &&
           (closing < state.rest.closing_speed || state.recent.has(a, b, now));
}

}  // namespace carom
