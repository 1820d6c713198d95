#include "event_driven/candidates.hpp"

#include <algorithm>

namespace carom {

namespace {

/// Two centres further apart than this cannot matter to each other before one of them crosses a cell wall. A swept ball
/// is larger than its sphere, off its centre, and ends off its cell by at most `series_below` radii each; the last per
/// cent covers all rounding.
double reach(const State& state)
{
    const double largest = *std::max_element(state.radii.begin(), state.radii.end());
    return 2 * largest * (1 + 3 * state.scene.rest.series_below) * 1.01;
}

}  // namespace

Candidates choose_candidates(const State& state, BroadPhase wanted)
{
    const std::size_t n = state.flights.size();
    if (wanted == BroadPhase::automatic) wanted = automatic_broad_phase(n);
    if (n < 2 || wanted == BroadPhase::all_pairs) return AllPairs(static_cast<BodyId>(n));
    std::vector<Place> places;
    places.reserve(n);
    for (const auto& f : state.flights) places.push_back(f.place);
    return CellGrid(state.frame, places, reach(state));
}

}  // namespace carom
