/// \file
/// A Zeno series: infinitely many bounces of one sphere on one plane, summed in closed form.
#pragma once

#include <carom/types.hpp>

namespace carom {

/// What follows a bounce that left with normal speed v0 > 0 under gravity g_n > 0 towards the plane: bounce k comes
/// T_k = 2 v0 / g_n (1 + e + ... + e^(k-1)) later, all of them within `duration`. e^k is found by products, never by a
/// logarithm: one rounding there picks the wrong bounce.
struct Series {
    double normal_speed = 0;           ///< v0 [length/time]
    double gravity = 0;                ///< g_n [length/time^2]
    double restitution = 0;            ///< e in (0, 1)
    double tangential = 1;             ///< alpha in [0, 1], acts at each bounce
    Vec3 velocity = Vec3::Zero();      ///< tangential, after the first bounce [length/time]
    Vec3 acceleration = Vec3::Zero();  ///< tangential [length/time^2]

    double first_flight() const { return 2 * normal_speed / gravity; }
    double duration() const { return first_flight() / (1 - restitution); }
    /// Of the first and highest flight [length].
    double height() const { return 0.5 * normal_speed * (normal_speed / gravity); }
};

/// Somewhere inside a series.
struct SeriesState {
    double height = 0;             ///< above contact [length]
    double normal_speed = 0;       ///< away from the plane [length/time]
    Vec3 shift = Vec3::Zero();     ///< tangential, since the start [length]
    Vec3 velocity = Vec3::Zero();  ///< tangential [length/time]
};

/// State at time tau after the start, 0 <= tau < duration [time].
SeriesState state_in(const Series& series, double tau);
/// State at its end: height and normal speed 0.
SeriesState state_at_end(const Series& series);

}  // namespace carom
