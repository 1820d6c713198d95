/// \file
/// What becomes of the bodies of a component once their velocities are those after the instant: which contacts persist,
/// and how the bodies move on.
#pragma once

#include "gather/component.hpp"
#include "hold/outcome.hpp"

namespace carom {

struct HeldContacts {
    std::vector<char> persists;  ///< by contact
    /// By contact, along the normal on its `a`: what took the speed of slow contacts. Below 0 where one that opened
    /// slowly was held [mass length/time].
    std::vector<double> impulses;
};

/// Contacts that are closed and neither open nor close are candidates; those whose forces keep them persist, the others
/// open. Bodies in contacts that carry force while their normals turn go on numerically.
/// \param component its problem has the velocities after
/// \param out gets changes of all its bodies, what settling and stabilising took, numeric steps and their penetration
HeldContacts hold(const State& state, ContactComponent component, const EpochTime& now, EventOutcome& out);

}  // namespace carom
