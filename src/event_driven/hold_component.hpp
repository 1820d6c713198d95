/// \file
/// What becomes of the bodies of a component once their velocities are those after the instant: which contacts persist,
/// and how the bodies move on.
#pragma once

#include "event_driven/component.hpp"

namespace carom {

/// How one body goes on.
struct MemberChange {
    BodyId body = no_body;
    Flight flight;
    Vec3 acceleration = Vec3::Zero();         ///< its own, if the flight's is [length/time^2]
    std::vector<PersistentContact> contacts;  ///< if the support is several_supports
    Piece piece;                              ///< if the mode is numeric
    bool rests_on = false;                    ///< it rested and rests, in the same contacts: only forces are new
};

struct HeldComponent {
    std::vector<MemberChange> changes;  ///< all bodies of the component
    std::vector<char> persists;         ///< by contact
    /// By contact, along the normal on its `a`: what took the speed of slow contacts. Below 0 where one that opened
    /// slowly was held [mass length/time].
    std::vector<double> impulses;
    EnergyTaken taken;
    std::int64_t numeric_steps = 0;
    double depth = 0;  ///< of numeric pieces, see NumericMotion [length]
};

/// Contacts that are closed and neither open nor close are candidates; those whose forces keep them persist, the others
/// open. Bodies in contacts that carry force while their normals turn go on numerically.
/// \param component flights with the velocities after
HeldComponent hold(const State& state, ContactComponent component, const EpochTime& now);

}  // namespace carom
