/// \file
/// Which broad phase a run takes, and how far it must see.
#pragma once

#include "broad/all_pairs.hpp"
#include "broad/cell_grid.hpp"
#include "event_driven/state.hpp"

#include <variant>

namespace carom {

using Candidates = std::variant<AllPairs, CellGrid>;

/// All pairs for few spheres, a cell grid for many, unless the method says which.
Candidates choose_candidates(const State& state, BroadPhase wanted);

}  // namespace carom
