/// \file
/// Places and accelerations of flights as a run shows them, in plain doubles.
#pragma once

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

}  // namespace carom::study
