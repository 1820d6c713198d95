/// \file
/// The return of a sphere to the fixed one that it has just left: bounces that get lower and lower until rounding ends
/// them.
#pragma once

#include "motion/relative.hpp"

#include <optional>

namespace carom {

/// Whether a contact that is alone bounces until rounding ends it, and not until it closes slower than a threshold.
inline bool bounces_to_rounding(const State& state, BodyId a, BodyId b)
{
    const double e = state.law(a, Partner::sphere(b)).restitution;
    return 0 < e && e < 1 && state.scene.rest.policy == RestPolicy::contact;
}

/// The time from m.from to the return of a sphere in flight that touches a fixed one, leaves it and is pressed on it,
/// where the bounce is so low that the normal hardly turns; none otherwise. The root at 0 is divided out, so that the
/// time is known to its own rounding, however low the bounce: that of the gap over the speed would be far larger.
std::optional<double> low_return(const State& state, BodyId a, BodyId b, const PairMotion& m);

}  // namespace carom
