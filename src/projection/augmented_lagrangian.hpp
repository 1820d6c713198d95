/// \file
/// The point of a polyhedron that is nearest to a given one, for thousands of half-spaces that each concern one vector
/// or two.
#pragma once

#include "projection/half_space.hpp"

namespace carom {

struct AugmentedLagrangianResult {
    Projection projection;
    int newton_steps = 0, factorisations = 0, updates = 0;
};

/// Proximal method of multipliers; its convex piecewise quadratic problems are solved by Newton steps with exact line
/// search on a sparse factor that follows the active set. Hermans, Themelis and Patrinos, QPALM: a proximal augmented
/// Lagrangian method for nonconvex quadratic programs, Mathematical Programming Computation 14 (2022),
/// https://doi.org/10.1007/s12532-022-00218-0, here for the convex program |y|^2 / 2 whose Hessian is the unit matrix.
/// Dependent half-spaces need no care: the matrix is the unit matrix and more. Ours: the rule for
/// the penalty, and that every step's slacks are those of the point which the multipliers give. Slacks are
/// satisfied to 100 tolerances. Every loop is bounded; a result that is not complete is still start + pushes.
/// \param guess multipliers to begin with, by half-space. The point does not depend on them beyond rounding; the work
/// does.
AugmentedLagrangianResult augmented_lagrangian(const ProjectionProblem& problem, std::span<const double> guess);

}  // namespace carom
