/// \file
/// Projection on a polyhedron whose half-spaces each concern one vector or two: split into parts that share nothing,
/// each solved by what suits its size.
#pragma once

#include "projection/half_space.hpp"
#include "projection/tolerances.hpp"

namespace carom {

/// Multipliers by half-space to begin with. They save time in large parts.
using Guess = std::optional<std::span<const double>>;

/// The point nearest to `problem.start` that satisfies the half-spaces listed in `chosen`, each once. The others are
/// ignored, their multipliers 0. Slacks hold to the tolerance, in parts of more than `dense_limit` half-spaces (with a
/// guess, of more than `guessed_limit`) to 100 of them.
Projection project(const ProjectionProblem& problem, std::span<const int> chosen, Guess guess = {});

/// The same with all half-spaces.
Projection project(const ProjectionProblem& problem, Guess guess = {});

}  // namespace carom
