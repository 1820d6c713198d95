/// \file
/// Projected Gauss-Seidel on the multipliers of half-spaces: one after the other is satisfied, there and back again.
#pragma once

#include "projection/half_space.hpp"

namespace carom {

/// Hildreth, A quadratic programming procedure, Naval Research Logistics Quarterly 4 (1957),
/// https://doi.org/10.1002/nav.3800040113. Every step brings the point nearer to the solution, none makes anything
/// worse; it approaches the solution but need not reach it.
/// \param sweeps every second one in reverse order
/// \param multipliers of half-spaces, >= 0: where to begin
Projection gauss_seidel(const ProjectionProblem& problem, int sweeps, std::vector<double> multipliers);

}  // namespace carom
