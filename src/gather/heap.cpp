#include "gather/heap.hpp"

#include "motion/relative.hpp"

#include <algorithm>
#include <vector>

namespace carom {

bool is_in_heap(const State& state, BodyId body, const EpochTime& now, const Neighbourhood& neighbourhood)
{
    std::vector<BodyId> members{body};
    for (std::size_t k = 0; k < members.size(); ++k) {
        const BodyId own = members[k];
        if (state.bodies.is_in_piece(own) || members.size() > largest_group) return true;
        const Flight flight = advanced(state, own, now);
        for (const BodyId other : neighbourhood(own)) {
            const double margin = heap_reach * std::min(state.radius(own), state.radius(other));
            if (state.is_fixed(other) || !may_touch(state, own, flight, other, margin)) continue;
            const double reach = state.radius(own) + state.radius(other) + margin;
            const Vec3 apart = separation(state.frame, flight.place, advanced(state, other, now).place);
            if (apart.squaredNorm() <= reach * reach &&
                std::find(members.begin(), members.end(), other) == members.end())
                members.push_back(other);
        }
    }
    return false;
}

}  // namespace carom
