#include "motion/low_return.hpp"

#include "math/length.hpp"

#include <cmath>

namespace carom {

std::optional<double> low_return(const State& state, BodyId a, BodyId b, const PairMotion& m)
{
    const BodyId flyer = state.is_fixed(a) ? b : a, other = flyer == a ? b : a;
    if (!state.is_fixed(other) || state.bodies.kind(flyer) != MotionKind::flying || !bounces_to_rounding(state, a, b))
        return {};
    const double size = m.contact_distance + state.frame.cell_size;
    if (std::abs(length(m.r) - m.contact_distance) > touching * size) return {};
    // |r + v t + g t^2/2|^2 = |r|^2, divided by t.
    const Accelerations& accelerations = state.bodies.accelerations();
    const Vec3 g = accelerations[m.acceleration_a] - accelerations[m.acceleration_b];
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
