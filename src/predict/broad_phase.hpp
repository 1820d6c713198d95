/// \file
/// Broad phases of a run, and how far they must see.
#pragma once

#include "broad/all_pairs.hpp"
#include "broad/cell_grid.hpp"
#include "motion/state.hpp"
#include "predict/tolerances.hpp"

#include <algorithm>
#include <type_traits>

namespace carom {

/// Distance of two centres [length] beyond which their spheres cannot matter to each other before one of them crosses a
/// cell wall. A swept ball is larger than its sphere, off its centre, and ends off its cell by at most `series_below`
/// radii each.
inline double broad_phase_reach(const State& state)
{
    double largest = 0;
    for (BodyId i = 0; i < state.count(); ++i) largest = std::max(largest, state.radius(i));
    return 2 * largest * (1 + 3 * state.scene.rest.series_below) * reach_slack;
}

template <class BroadPhase>
BroadPhase make_broad_phase(const State& state)
{
    if constexpr (std::is_same_v<BroadPhase, AllPairs>) {
        return AllPairs(state.count());
    } else {
        std::vector<Place> places;
        for (BodyId i = 0; i < state.count(); ++i) places.push_back(state.flight(i).place);
        return BroadPhase(state.frame, places, broad_phase_reach(state));
    }
}

}  // namespace carom
