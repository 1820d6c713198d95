/// \file
/// The exact projection of velocities on the rates that rows want.
#pragma once

#include "window/relaxation.hpp"

#include <span>

namespace carom {

/// Sets the rows' multipliers to those of the projection of `goal` (interior_point.hpp).
/// \param inverse_masses by velocity; those of 0 keep theirs
/// \param change [sqrt(energy)] >= 0: size of the changes to be expected, in the metric of kinetic energy; more where
/// rates miss more
/// \returns factorisations
int project_rows(std::vector<RelaxationRow>& rows, std::span<const Vec3> goal, std::span<const double> inverse_masses,
                 double change);

}  // namespace carom
