/// \file
/// An impact of two spheres that touch nothing else. Thresholds are for heaps: here bounces go on until rounding
/// (docs/impacts.md, section 4).
#pragma once

#include "gather/may_touch.hpp"
#include "queue/key.hpp"

namespace carom {

struct LoneImpact {
    bool rebounds = false;  ///< with the restitution of its law, however slow it closes
    bool dies_out =
        false;  ///< one of bounces that get lower and lower and end by themselves: the guard leaves it alone
    /// Time by which rest comes early at most, where a threshold ends bounces because too many are to come [time].
    double early = 0;
};

/// Whether the impact `key` is a lone one, and what becomes of it; nothing is true of those that thresholds are for.
/// \param a,b flights of its spheres at this instant \param normal from b to a \param closing speed, >= 0 [length/time]
/// \param returns whether its time is that of a low_return
LoneImpact lone_impact(const State& state, const Key& key, const Flight& a, const Flight& b, const Vec3& normal,
                       double closing, bool returns, const Neighbourhood& neighbourhood);

}  // namespace carom
