#include "motion/low_return.hpp"

#include "flight/damping.hpp"
#include "toi/damped_plane.hpp"

namespace carom {

std::optional<double> damped_low_return(const PairMotion& m, const Vec3& g, double k)
{
    // |r + v s + g q|^2 = |r|^2, divided by s: 2 r.v + 2 r.g p + s |v + g p|^2 with p = q / s.
    const double rate = 2 * m.r.dot(m.v), pull = m.v.squaredNorm() + m.r.dot(g);
    if (!(rate > 0 && pull < 0)) return {};
    double t = damped_plane_root(0, rate / 2, pull, k).t;
    // What the normal turns, and how much v^2 is damped.
    if (t * (std::abs(m.v.dot(g)) + t * g.squaredNorm() / 4 + k * m.v.squaredNorm()) > low_turn * -pull) return {};
    for (int i = 0; i < return_steps; ++i) {
        const Damping<double> d = damping(k, t);
        const double p = d.fall / d.way, p_rate = 1 - p * (d.decay / d.way);
        const Vec3 mean = m.v + p * g;
        const double value = rate + 2 * p * m.r.dot(g) + d.way * mean.squaredNorm(),
                     slope = 2 * p_rate * (m.r.dot(g) + d.way * mean.dot(g)) + d.decay * mean.squaredNorm();
        t -= value / slope;
    }
    return t;
}

}  // namespace carom
