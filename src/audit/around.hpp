/// \file
/// Disturbances around each sphere in an interval, looked at so that one contact is not blamed for another.
#pragma once

#include "audit/interval.hpp"

#include <set>
#include <utility>
#include <vector>

namespace carom::audit {

/// A sphere that moves, and the sphere or plane that it meets.
using Pair = std::pair<BodyId, BodyId>;
using Pairs = std::set<Pair>;

struct Around {
    std::vector<int> contacts;   ///< by sphere: pairs of it that touch, may touch, or overlap
    std::vector<int> disturbed;  ///< by sphere: others near it that leave their flights, or have none
    Pairs pairs;                 ///< that touch, may touch, or overlap
};

/// \param pairs that touch or overlap, beside those that the interval has
Around around(const Scene& scene, const Interval& interval, Pairs pairs);

/// Whether nothing but the contact of this pair can have turned its bodies between `from` and the end of the interval.
bool is_alone(const Scene& scene, const Pair& pair, const Interval& interval, const Around& around, double from);

/// The bodies that may have touched a sphere in the interval, by its flight before or after it.
std::set<BodyId> possible_partners(const Scene& scene, BodyId body, const Interval& interval, const Around& around);

}  // namespace carom::audit
