/// \file
/// Projection on a polyhedron whose half-spaces each concern one vector or two: split into parts that share nothing,
/// each solved by what suits its size.
#pragma once

#include "projection/half_space.hpp"
#include "projection/tolerances.hpp"

namespace carom {

/// The point nearest to `problem.start` that satisfies the half-spaces listed in `chosen`, each once. The others are
/// ignored, their multipliers 0. Slacks hold to the tolerance, in parts of more than `dense_limit` half-spaces to 100
/// of them. \param guess by half-space, or empty: multipliers to begin with, which save time in large parts
Projection project(const ProjectionProblem& problem, std::span<const int> chosen, std::span<const double> guess = {});

/// All of them.
Projection project(const ProjectionProblem& problem, std::span<const double> guess = {});

}  // namespace carom
