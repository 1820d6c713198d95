/// \file
/// Spheres near each other, before contacts are measured.
#pragma once

#include "flight/damping.hpp"
#include "gather/tolerances.hpp"
#include "motion/state.hpp"

#include <functional>
#include <span>

namespace carom {

/// Every sphere that may touch this one now; valid until the next call.
using Neighbourhood = std::function<std::span<const BodyId>(BodyId)>;

/// Whether the surfaces of `body` and `other` may be less than `margin` apart [length]; true of some that are not.
/// \param now the flight of `body` as if it began at this moment
inline bool may_touch(const State& state, BodyId body, const Flight& now, BodyId other, double margin)
{
    if (state.bodies.kind(other) == MotionKind::bouncing) return true;
    const Flight& f = state.flight(other);
    const double dt = state.frame.between(f.start, now.start);
    Vec3 r = separation(state.frame, now.place, f.place);
    if (state.drag > 0) {
        r -= displacement(f.velocity, state.acceleration(f), damping(state.drag, dt));
    } else {
        r -= dt * f.velocity;
        if (f.acceleration != Accelerations::none) r -= (0.5 * dt * dt) * state.acceleration(f);
    }
    const bool in_piece = state.bodies.is_in_piece(other) || state.bodies.is_in_piece(body);
    const double generous = in_piece ? look_slack_in_pieces : look_slack;
    const double reach = generous * (state.radius(body) + state.radius(other) + margin);
    return r.squaredNorm() <= reach * reach;
}

}  // namespace carom
