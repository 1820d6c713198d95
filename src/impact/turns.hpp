/// \file
/// Two contacts that close in turn, as those of a light body between heavy ones: many rounds of reflections at once.
#pragma once

#include "projection/half_space.hpp"

#include <optional>

namespace carom {

/// Multipliers of many rounds in which `first` and `second` are reflected one after the other.
struct Turns {
    double first = 0, second = 0;  ///< of the half-spaces, see `push`
};

/// The rounds u <- u - 2 (a_i.u) a_i, first i and then j, that are to come while unit normal a_i closes. The two
/// reflections are a rotation of the plane of a_i and a_j by twice their angle psi; as many of these are taken, found
/// by doubling, as leave i closing. (This project's.) \returns nothing if these are fewer than `fewest_turns`, or if
/// another half-space might close on the way by more than `closing` [as the vectors] \pre `first` closes, and no other
/// half-space
std::optional<Turns> turns(const ProjectionProblem& at, int first, int second, double closing);

}  // namespace carom
