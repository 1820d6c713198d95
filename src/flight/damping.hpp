/// \file
/// Linear drag, dv/dt = a - k v: x = x0 + v0 s + a q and v = v0 E + a s with E = exp(-k t), s = (1 - E) / k and
/// q = (t - s) / k. In s, which ends at 1/k, motions under one acceleration are straight relative to each other.
#pragma once

#include "flight/limits.hpp"
#include "math/exponential.hpp"

#include <carom/types.hpp>

namespace carom {

/// Effect of a time under drag k on a motion.
template <class Real>
struct Damping {
    Real decay;  ///< E [1]
    Real way;    ///< s [time]
    Real fall;   ///< q [time^2]
};

/// Relative errors: way and fall 6 u, decay (6 + 2 k t) u in double-double and 6 u in double, where the rounding of k t
/// is put back. \pre k > 0, t >= 0
template <class Real>
Damping<Real> damping(double k, Real t)
{
    const Real z = Real(k) * t;
    if (detail::head_of(z) <= damping_by_series_up_to) {
        // q / t^2 = (z - 1 + e^-z) / z^2, and all else from it without cancellation.
        const Real tail = exponential_tail(-z), mean = Real(1.0) - z * tail;
        return {Real(1.0) - z * mean, t * mean, (t * t) * tail};
    }
    Real decay = exponential(-z);
    if constexpr (std::is_same_v<Real, double>)
        if (decay > 0) decay -= decay * std::fma(k, t, -z);
    const Real way = (Real(1.0) - decay) / Real(k);
    return {decay, way, (t - way) / Real(k)};
}

/// The way x(t) - x(0) of a damped flight [length], and its velocity then [length/time]. \param acceleration without
/// drag
inline Vec3 displacement(const Vec3& velocity, const Vec3& acceleration, const Damping<double>& d)
{
    return d.way * velocity + d.fall * acceleration;
}
inline Vec3 velocity_after(const Vec3& velocity, const Vec3& acceleration, const Damping<double>& d)
{
    return d.decay * velocity + d.way * acceleration;
}

/// The time t at which (1 - exp(-k t)) / k = s. \pre k > 0, 0 <= k s < 1
template <class Real>
Real time_of_way(double k, Real s)
{
    const Real z = Real(k) * s;
    if (!(detail::head_of(z) > 0)) return s;
    return s * (minus_log_of_rest(z) / z);
}

/// The time after which a speed w against an acceleration g is 0: log(1 + k w / g) / k. \pre k, g > 0, w >= 0
inline double turning_time(double k, double w, double g)
{
    const double ratio = k * w / g;
    if (ratio <= 1) return time_of_way(k, w / (g + k * w));
    // Weak gravity may make the ratio larger than doubles are.
    return (std::isfinite(ratio) ? logarithm(1 + ratio) : logarithm(k * w) - logarithm(g)) / k;
}

}  // namespace carom
