/// \file
/// Projection on a polyhedron whose half-spaces each concern one vector or two: split into parts that share nothing,
/// each solved by what suits its size.
#pragma once

#include "math/half_space.hpp"

namespace carom {

/// The point nearest to `problem.start` that satisfies the half-spaces listed in `chosen`, each once. The others are
/// ignored, their multipliers 0.
Projection project(const ProjectionProblem& problem, std::span<const int> chosen);

/// All of them.
Projection project(const ProjectionProblem& problem);

}  // namespace carom
