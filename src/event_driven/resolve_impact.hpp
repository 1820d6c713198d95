/// \file
/// The two kinds of impact, see `resolve`.
#pragma once

#include "event_driven/resolve.hpp"

namespace carom {

Resolution resolve_sphere_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood);
Resolution resolve_plane_impact(const State& state, const Key& key, const Neighbourhood& neighbourhood);

/// Not carried out: an event for resolve_component.
inline Resolution coupled()
{
    Resolution out;
    out.coupled = true;
    return out;
}

/// After an impact the kernel must not see its contact close again; rounding may say otherwise. Nudges of growing size,
/// the first within a few ulps of the speed, end that: at most so many.
inline constexpr int most_nudges = 64;

}  // namespace carom
