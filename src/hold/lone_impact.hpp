/// \file
/// An impact of two spheres that touch nothing else. Thresholds are for heaps: here bounces go on until rounding
/// (docs/impacts.md, section 5).
#pragma once

#include "gather/may_touch.hpp"
#include "motion/kinematics.hpp"
#include "queue/key.hpp"

#include <optional>

namespace carom {

struct LoneImpact {
    bool rebounds = false;  ///< with the restitution of its law, however slow it closes
    /// One of bounces that get lower and lower and end by themselves: the guard leaves them alone.
    bool dies_out = false;
    /// Time by which rest comes early at most, where a threshold ends bounces because too many are to come [time].
    std::optional<double> early{};
};

/// Fate of the impact `key` if it is a lone one; nothing is true of the others, which thresholds are for.
/// \param a,b flights of its spheres at this instant \param returns whether its time is that of a low_return
LoneImpact lone_impact(const State& state, const Key& key, const Flight& a, const Flight& b,
                       const SphereEncounter& encounter, bool returns, const Neighbourhood& neighbourhood);

}  // namespace carom
