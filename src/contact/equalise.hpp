/// \file
/// The smallest change of velocities (or places) in the mass metric that gives contacts the rates (or gaps) wanted.
#pragma once

#include "contact/contact.hpp"

#include <span>

namespace carom {

struct EqualisingChange {
    std::vector<Vec3> change;  ///< by body
    std::vector<double>
        impulses;  ///< by contact, along the normal on a: they make the change (not always the only ones)
};

/// min sum m |d|^2 with n_i.(d_a - d_b) = wanted_i for all contacts, in the sense of least squares where contacts
/// contradict one another (see shortest_change). Redundant contacts do no harm; work is bounded, and so is the change:
/// no body goes further than 4096 times the largest that is wanted, as it would between contacts that nearly
/// contradict.
EqualisingChange equalising_change(const ContactProblem& cluster, std::span<const double> wanted);

}  // namespace carom
