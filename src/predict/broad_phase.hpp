/// \file
/// Broad phases of a run, and how far they must see.
#pragma once

#include "broad/all_pairs.hpp"
#include "broad/neighbour_lists.hpp"
#include "motion/state.hpp"
#include "predict/tolerances.hpp"

#include <carom/features.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace carom {

/// Distance from a body's centre [length] beyond which it cannot matter to others, up to theirs, before one of them
/// leaves what the broad phase knows of it. A swept ball is larger than its sphere, off its centre, and ends off its
/// cell by at most `series_below` radii each.
inline double broad_phase_reach(const State& state, BodyId body)
{
    return state.radius(body) * (1 + 3 * state.scene.rest.series_below) * reach_slack + state.widest_tie(body);
}

/// Distance [mean radius] by which lists of neighbours reach further: wider where spheres are sparse. Where they may
/// gather it is that of a liquid, so that lists are not long when they have.
inline double list_shell(const State& state)
{
    const bool may_gather = state.loses_energy || state.bodies.accelerations().has_gravity();
    const double fraction =
        std::clamp(packing_fraction(state.scene), may_gather ? liquid_fraction : sparsest_lists, 1.0);
    double mean = 0;
    for (BodyId i = 0; i < state.count(); ++i) mean += state.radius(i) / state.count();
    return mean * shell_at_half * std::pow(0.5 / fraction, shell_exponent);
}

/// \param origin of positions in lists: a place of a cell alone
template <class BroadPhase>
BroadPhase make_broad_phase(const State& state, const Place& origin)
{
    if constexpr (std::is_same_v<BroadPhase, AllPairs>) {
        return AllPairs(state.count());
    } else {
        std::vector<Place> places;
        std::vector<double> reaches;
        for (BodyId i = 0; i < state.count(); ++i) {
            places.push_back(state.flight(i).place);
            reaches.push_back(broad_phase_reach(state, i));
        }
        if constexpr (BroadPhase::has_lists)
            return BroadPhase(state.frame, origin, places, reaches, list_shell(state));
        else
            return BroadPhase(state.frame, places, 2 * *std::max_element(reaches.begin(), reaches.end()));
    }
}

}  // namespace carom
