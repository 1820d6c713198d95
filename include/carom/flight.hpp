/// \file
/// Flights, of which an event-driven run consists, as the engine stores them, to the last bit. Recordings keep them and
/// `verify` reads them.
#pragma once

#include <carom/types.hpp>

#include <array>
#include <optional>
#include <vector>

namespace carom {

/// The rulers of a run and the accelerations that occur in it.
struct RunFrame {
    double epoch_length = 1;  ///< [time], a power of two
    double cell_size = 1;     ///< [length], a power of two
    /// k >= 0 of the linear drag that damps every motion of the run [1/time].
    double drag = 0;
    /// The table in which FlightRecord::acceleration counts. Entry 0 is zero [length/time^2].
    std::vector<Vec3> accelerations;
};

/// A Zeno series of bounces on one plane, summed in closed form (docs/impacts.md, section 5).
struct SeriesRecord {
    double normal_speed = 0;           ///< with which the first bounce left, > 0 [length/time]
    double gravity = 0;                ///< towards the plane, > 0 [length/time^2]
    double restitution = 0;            ///< in (0, 1)
    double tangential = 1;             ///< in [0, 1], acts at each bounce
    Vec3 velocity = Vec3::Zero();      ///< tangential, after the first bounce [length/time]
    Vec3 acceleration = Vec3::Zero();  ///< tangential [length/time^2]
};

/// FlightRecord::support of what is in persistent contact with spheres, or with several planes.
inline constexpr std::int32_t several_supports = -2;
/// FlightRecord::acceleration of a flight that has one of its own.
inline constexpr std::int32_t own_acceleration = -1;

/// A body's motion from `start` until its next flight: with t the time since `start`, x = x0 + v0 t + a t^2 / 2, or,
/// where RunFrame::drag is k > 0, x = x0 + v0 s + a (t - s) / k with s = (1 - exp(-k t)) / k; in exact arithmetic on
/// the numbers here, x0 and v0 each being a sum of doubles (the low parts are 0 in runs of plain doubles). Origin and
/// start time of the scene play no part.
struct FlightRecord {
    BodyId body = no_body;
    EpochTime start;
    std::array<std::int64_t, 3> cell{};    ///< x0 = cell * cell_size + local + local_low
    std::array<double, 3> local{};         ///< [length]
    std::array<double, 3> local_low{};     ///< [length]
    std::array<double, 3> velocity{};      ///< v0 = velocity + velocity_low [length/time]
    std::array<double, 3> velocity_low{};  ///< [length/time]
    std::int32_t acceleration = 0;         ///< which of RunFrame::accelerations, or own_acceleration
    std::array<double, 3> own{};           ///< its own acceleration, otherwise 0 [length/time^2]
    std::int32_t support = -1;  ///< plane that carries a series, a slide or a rest; -1 if none; or several_supports
    bool guarded = false;       ///< in a window of the guard: a straight line, mode numeric
    Mode mode = Mode::flying;
    std::optional<SeriesRecord> series;  ///< if and only if mode is series
};

}  // namespace carom
