/// \file
/// A cheap look before contacts are measured.
#pragma once

#include "event_driven/state.hpp"

namespace carom {

/// Can the surfaces of `body` and `other` be less than `margin` apart [length]? Said of many that are not, too.
/// \param now the flight of `body` as if it began at this moment
inline bool may_touch(const State& state, BodyId body, const Flight& now, BodyId other, double margin)
{
    const Flight& f = state.flight(other);
    if (f.mode == Mode::series) return true;
    const double dt = state.frame.between(f.start, now.start);
    const Vec3 shift = displacement(f.velocity, state.accelerations[f.acceleration], dt);
    const Vec3 r = separation(state.frame, now.place, f.place) - shift;
    const bool numeric = f.mode == Mode::numeric || now.mode == Mode::numeric;
    const double generous = numeric ? 1.001 : 1.00005;  // such pieces are no parabolas
    const double reach = generous * (state.radius(body) + state.radius(other) + margin);
    return r.squaredNorm() <= reach * reach;
}

}  // namespace carom
