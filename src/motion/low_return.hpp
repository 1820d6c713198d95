/// \file
/// The return of a sphere to the fixed one that it has just left: bounces that get lower and lower until rounding ends
/// them.
#pragma once

#include "math/length.hpp"
#include "motion/relative.hpp"

#include <cmath>
#include <optional>

namespace carom {

/// Whether a contact that is alone bounces until rounding ends it, and not until it closes slower than a threshold.
inline bool bounces_to_rounding(const State& state, BodyId a, BodyId b)
{
    const double e = state.law(a, Partner::sphere(b)).restitution;
    return 0 < e && e < 1 && state.scene.rest.policy == RestPolicy::contact;
}

/// low_return under drag, with g the acceleration of a relative to b. \pre as there, but for how low the bounce is
std::optional<double> damped_low_return(const PairMotion& m, const Vec3& g, double k);

/// The time from m.from to the return of a sphere in flight that touches a fixed one, leaves it and is pressed on it,
/// where the bounce is so low that the normal hardly turns; none otherwise. The root at 0 is divided out, so that the
/// time is known to its own rounding, however low the bounce: that of the gap over the speed would be far larger.
inline std::optional<double> low_return(const State& state, BodyId a, BodyId b, const PairMotion& m)
{
    const BodyId flyer = state.is_fixed(a) ? b : a, other = flyer == a ? b : a;
    if (!state.is_fixed(other) || state.bodies.kind(flyer) != MotionKind::flying || !bounces_to_rounding(state, a, b))
        return {};
    const double size = m.contact_distance + state.frame.cell_size;
    if (std::abs(length(m.r) - m.contact_distance) > touching * size) return {};
    // |r + v t + g t^2/2|^2 = |r|^2, divided by t.
    const Accelerations& accelerations = state.bodies.accelerations();
    const Vec3 g = accelerations[m.acceleration_a] - accelerations[m.acceleration_b];
    if (state.drag > 0) [[unlikely]]
        return damped_low_return(m, g, state.drag);
    const double rate = 2 * m.r.dot(m.v), pull = m.v.squaredNorm() + m.r.dot(g), turn = m.v.dot(g),
                 fall = g.squaredNorm() / 4;
    if (!(rate > 0 && pull < 0)) return {};
    double t = -rate / pull;
    if (t * (std::abs(turn) + t * fall) > low_turn * -pull) return {};
    for (int i = 0; i < return_steps; ++i)
        t -= (rate + t * (pull + t * (turn + t * fall))) / (pull + t * (2 * turn + 3 * t * fall));
    return t;
}

}  // namespace carom
