/// \file
/// Tracks: a quick look at bodies, in 64 bytes each. A track is a cache of a body's flight, carried to a moment that
/// all tracks share; nothing accumulates in it, and no event takes place at a time that it tells. It only says which
/// contacts certainly do not come in time, so that few are left for the exact kernel.
#pragma once

#include "motion/state.hpp"
#include "predict/tolerances.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace carom {

struct alignas(64) Track {
    double place[3] = {0, 0, 0};     ///< carried to the common moment, from the tracks' origin [length]
    double velocity[3] = {0, 0, 0};  ///< likewise [length/time]
    /// Radius with the widest gap that counts as closed, and all roundings of this track and of the exact kernel
    /// [length].
    double reach = 0;
    AccelerationId acceleration = Accelerations::none;
    std::int32_t is_parabola = 0;  ///< 0 or 1; 0: the rest means nothing (a series, a piece, drag)
};

/// A contact that may come.
struct Meeting {
    static constexpr double unknown = std::numeric_limits<double>::infinity();

    double soonest = unknown;  ///< it does not come before this time from now, see `soonest_contact` [time]
    BodyId other = no_body;
};

class Tracks {
public:
    /// \post every body has a track
    explicit Tracks(const State& state);

    const Track& operator[](BodyId body) const { return tracks_[static_cast<std::size_t>(body)]; }
    /// The time since the common moment [time].
    double age(const Frame& frame, const EpochTime& now) const { return frame.between(moment_, now); }
    /// Square of a relative speed up to which rounding may turn it; 0 without gravity [length^2/time^2].
    double least_square() const { return least_square_; }
    /// The origin of places, whole cells; and its position, rounded to doubles [length].
    const Place& origin() const { return origin_; }
    const Vec3& origin_position() const { return origin_position_; }

    /// Follows a flight that has just changed. The common moment moves on now and
    /// then.
    void follow(const State& state, BodyId body, const EpochTime& now);

    /// Meetings of the bodies `near` that may meet this one, in no particular order. \param room for them, which
    /// grows where it is too small
    template <bool gravity>
    std::span<Meeting> meetings(BodyId body, double age, std::span<const BodyId> near,
                                std::vector<Meeting>& room) const;
    /// Bodies that may be in reach now: not `are_apart`. \param own the track of the body now
    std::span<const BodyId> in_reach(const State& state, const Track& own, double age, std::span<const BodyId> near,
                                     std::vector<BodyId>& found) const;

    /// A body's track carried on to `age`.
    Track at(const State& state, BodyId body, double age) const;

private:
    void set(const State& state, BodyId body);
    void renew(const State& state, const EpochTime& now);

    std::vector<Track> tracks_;  ///< by body
    EpochTime moment_{};
    Place origin_{};
    Vec3 origin_position_ = Vec3::Zero();
    double least_square_ = 0;
    std::int64_t changes_ = 0;  ///< since the common moment moved
};

/// A time before which two bodies of one acceleration are certainly out of each other's reach, or certainly separate;
/// infinite if that is for ever, 0 if it is not certain even now [time from now]. \param age of the tracks now
template <bool gravity>
double soonest_contact(const Track& a, const Track& b, double age, double least_square)
{
    const double vx = a.velocity[0] - b.velocity[0], vy = a.velocity[1] - b.velocity[1],
                 vz = a.velocity[2] - b.velocity[2];
    const double rx = (a.place[0] - b.place[0]) + age * vx, ry = (a.place[1] - b.place[1]) + age * vy,
                 rz = (a.place[2] - b.place[2]) + age * vz;
    const double approach = rx * vx + ry * vy + rz * vz, square = rx * rx + ry * ry + rz * rz, sum = a.reach + b.reach;
    const double gap = square * (1 - track_rounding) - sum * sum;
    constexpr double forever = std::numeric_limits<double>::infinity();
    const auto speed_square = [&] { return vx * vx + vy * vy + vz * vz; };
    if constexpr (gravity)
        if (!(speed_square() > least_square)) return 0;
    if (approach >= 0) {  // half of all pairs
        if (gap > 0) return forever;
        return approach * approach > certain_separation * (square * speed_square()) ? forever : 0;
    }
    if (gap <= 0) return 0;
    const double discriminant = approach * approach - speed_square() * gap;
    if (discriminant < 0) return forever;
    return gap / (std::sqrt(discriminant) - approach);
}

/// Whether two bodies are certainly out of each other's reach now. \param own the track of one, at `age`
inline bool are_apart(const State& state, const Track& own, const Track& other, double age)
{
    double rx = own.place[0] - (other.place[0] + age * other.velocity[0]),
           ry = own.place[1] - (other.place[1] + age * other.velocity[1]),
           rz = own.place[2] - (other.place[2] + age * other.velocity[2]);
    if (other.acceleration != Accelerations::none) {
        const Vec3 way = (0.5 * age * age) * state.bodies.accelerations()[other.acceleration];
        rx -= way[0];
        ry -= way[1];
        rz -= way[2];
    }
    const double sum = own.reach + other.reach;
    return other.is_parabola && (rx * rx + ry * ry + rz * rz) * (1 - track_rounding) > sum * sum;
}

/// A plane as tracks see it.
class TrackPlane {
public:
    TrackPlane(const Plane& plane, const Vec3& origin);

    /// Whether a body certainly does not reach the plane within `time`, which may
    /// be infinite [time]. \param own its track now
    bool is_out_of_reach(const State& state, const Track& own, double time) const;
    /// Whether a sphere around a position, from the tracks' origin, may touch the
    /// plane. \param radius [length]
    bool is_near(const Vec3& position, double radius) const;

private:
    double above(const double x[3]) const { return normal_[0] * x[0] + normal_[1] * x[1] + normal_[2] * x[2]; }

    double normal_[3];
    double offset_;     ///< from the tracks' origin [length]
    double thickness_;  ///< half of it, with the rounding of the offset [length]
    bool is_plate_;
};

}  // namespace carom
