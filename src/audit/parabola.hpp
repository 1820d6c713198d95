/// \file
/// A flight as frames show it: a parabola under a known acceleration, damped where the scene has drag, through places
/// with a known error.
#pragma once

#include "flight/damping.hpp"

#include <carom/types.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace carom::audit {

/// Place of a body at the time of a frame.
struct Sighting {
    double time = 0;            ///< [time]
    Vec3 place = Vec3::Zero();  ///< [length]
    double error = 0;           ///< bound on the distance from the true place [length]
};

/// All that moves a body in flight beside its velocity.
struct Pull {
    Vec3 acceleration = Vec3::Zero();  ///< without drag [length/time^2]
    double drag = 0;                   ///< k >= 0 of dv/dt = acceleration - k v [1/time]

    /// Effect of `duration` on a flight, of either sign; without drag that is {1, t, t^2/2}.
    Damping<double> over(double duration) const;
    /// The duration in which a flight has that `way` of `Damping`; infinite if it never has.
    double duration_of(double way) const;
};

struct Parabola {
    double time = 0;  ///< at which place and velocity are given [time]
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
    Pull pull;
    double middle = 0;          ///< of the sightings, where the place is known best [time]
    double place_error = 0;     ///< there [length]
    double velocity_error = 0;  ///< at `time` [length/time]

    Vec3 place_at(double t) const;
    Vec3 velocity_at(double t) const;
    /// Bound on the distance of `place_at` from the true place [length].
    double error_at(double t) const;
    double velocity_error_at(double t) const { return velocity_error * pull.over(t - time).decay; }
    /// Bound on the acceleration between two times, drag included [length/time^2].
    double bend(double from, double to) const;
};

/// The flight by least squares through two or three sightings; none if no parabola is within their errors of each.
/// \param time_error bound on the error of their times [time]
std::optional<Parabola> fitted(std::span<const Sighting> sightings, const Pull& pull, double time_error);

/// The bend of a flight, as three sightings have it.
enum class Bend : std::uint8_t {
    hidden,   ///< errors are as large as what the pull bends
    shown,    ///< not on a straight line
    straight  ///< on a straight line, though the pull would bend it: between the steps of a method, or carried
};
/// \pre three sightings
Bend bend_of(std::span<const Sighting> sightings, const Pull& pull, double time_error);

/// The same flight by its place and velocity at another time.
Parabola given_at(Parabola flight, double time);

/// A body that never moves.
Parabola standing(const Vec3& place);

/// Motion of a as seen from b, given at the time at which a is; their errors add up. \pre both have one drag, or b
/// stands still
Parabola relative(const Parabola& a, const Parabola& b);

/// One sudden change of velocity that leads from one flight to another.
struct Turn {
    Vec3 change = Vec3::Zero();  ///< of velocity [length/time]
    double time = 0, error = 0;  ///< at which the flights are nearest to each other [time]
    bool is_single = false;      ///< they meet there, as far as errors say
};

/// None if the flights are one, or differ in place alone. \pre they have one pull
std::optional<Turn> turn_between(const Parabola& before, const Parabola& after);

/// Whether both are the same flight, as far as errors say. \pre they have one pull
bool is_same(const Parabola& before, const Parabola& after);

/// Whether they go alike, but one at another place than any change of velocity within `duration` before the second is
/// given could have brought it to. \pre they have one pull
bool is_displaced(const Parabola& before, const Parabola& after, double duration);

}  // namespace carom::audit
