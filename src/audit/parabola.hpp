/// \file
/// A flight as frames show it: a parabola under a known acceleration through places with a known error.
#pragma once

#include <carom/types.hpp>

#include <optional>
#include <span>

namespace carom::audit {

/// Place of a body at the time of a frame.
struct Sighting {
    double time = 0;            ///< [time]
    Vec3 place = Vec3::Zero();  ///< [length]
    double error = 0;           ///< bound on the distance from the true place [length]
};

struct Parabola {
    double time = 0;  ///< at which place and velocity are given [time]
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();
    double middle = 0;          ///< of the sightings, where the place is known best [time]
    double place_error = 0;     ///< there [length]
    double velocity_error = 0;  ///< [length/time]

    Vec3 place_at(double t) const;
    Vec3 velocity_at(double t) const { return velocity + (t - time) * acceleration; }
    /// Bound on the distance of `place_at` from the true place [length].
    double error_at(double t) const { return place_error + std::abs(t - middle) * velocity_error; }
};

/// The flight by least squares through two or three sightings; none if no parabola is within their errors of each.
/// \param time_error bound on the error of their times [time]
std::optional<Parabola> fitted(std::span<const Sighting> sightings, const Vec3& acceleration, double time_error);

/// The same flight by its place and velocity at another time.
Parabola given_at(Parabola flight, double time);

/// A body that never moves.
Parabola standing(const Vec3& place);

/// Motion of a as seen from b, given at the time at which a is; their errors add up.
Parabola relative(const Parabola& a, const Parabola& b);

/// One sudden change of velocity that leads from one flight to another.
struct Turn {
    Vec3 change = Vec3::Zero();  ///< of velocity [length/time]
    double time = 0, error = 0;  ///< at which the flights are nearest to each other [time]
    bool is_single = false;      ///< they meet there, as far as errors say
};

/// None if the flights are one, or differ in place alone. \pre they have one acceleration
std::optional<Turn> turn_between(const Parabola& before, const Parabola& after);

/// Whether both are the same flight, as far as errors say. \pre they have one acceleration
bool is_same(const Parabola& before, const Parabola& after);

}  // namespace carom::audit
