/// \file
/// Places and accelerations of flights as a run shows them, in plain doubles.
#pragma once

#include "stepping/damped_times.hpp"

#include <carom/flight.hpp>

namespace carom::study {

inline Vec3 vector_of(const std::array<double, 3>& v)
{
    return {v[0], v[1], v[2]};
}

/// The moment in seconds since the start of the run, as `Event::time` [time].
inline double seconds_of(const RunFrame& frame, const EpochTime& at)
{
    return static_cast<double>(at.epoch) * frame.epoch_length + at.offset;
}

/// The place of the centre as the flight begins [length].
inline Vec3 place_of(const RunFrame& frame, const FlightRecord& flight)
{
    const Vec3 cell(static_cast<double>(flight.cell[0]), static_cast<double>(flight.cell[1]),
                    static_cast<double>(flight.cell[2]));
    return cell * frame.cell_size + vector_of(flight.local);
}

/// [length/time^2]
inline Vec3 acceleration_of(const RunFrame& frame, const FlightRecord& flight)
{
    return flight.acceleration == own_acceleration ? vector_of(flight.own)
                                                   : frame.accelerations[static_cast<std::size_t>(flight.acceleration)];
}

/// The place of a flight, a time after its begin: on a parabola, with drag k on a damped flight [length].
inline Vec3 place_after(const Vec3& place, const Vec3& velocity, const Vec3& acceleration, double drag, double time)
{
    if (drag == 0) return place + time * (velocity + (time / 2) * acceleration);
    return stepping::place_after(stepping::damped_times(drag, time), place, velocity, acceleration);
}

/// Its velocity then [length/time].
inline Vec3 velocity_after(const Vec3& velocity, const Vec3& acceleration, double drag, double time)
{
    return stepping::velocity_after(stepping::damped_times(drag, time), drag, velocity, acceleration);
}

}  // namespace carom::study
