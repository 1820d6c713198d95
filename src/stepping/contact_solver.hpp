/// \file
/// One complementarity problem for the contacts of a step.
#pragma once

#include "core/patience.hpp"
#include "stepping/bodies.hpp"
#include "stepping/contact.hpp"

#include <vector>

namespace carom::stepping {

struct ContactRow {
    Contact contact;
    double least = 0;    ///< the normal velocity afterwards is to be at least this [length/time]
    double impulse = 0;  ///< >= 0, result: normal, on a [mass length/time]
};

/// Changes the velocities by impulses with 0 <= impulse _|_ c+ - least >= 0 for every contact, by projected
/// Gauss-Seidel in the order of the rows: each in turn gets what it lacks, never less than nothing in all (Moreau,
/// Unilateral contact and dry friction in finite freedom dynamics, 1988; Jean, The non-smooth contact dynamics method,
/// 1999). Ends when a sweep changes no normal velocity by more than 1e-13 of the largest that was lacking, or of
/// `scale` if that is more [length/time], or after `sweeps`.
/// \pre the velocities have the impulses of the rows already, sweeps >= 1 \return sweeps made
int solve_contacts(Bodies& bodies, std::vector<ContactRow>& rows, int sweeps, Patience& patience, double scale = 0);

}  // namespace carom::stepping
