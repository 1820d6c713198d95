/// \file
/// The rulers of a run: how long an epoch is and how large a cell. Both are powers of two, so that splitting a time or
/// a place into a whole number and a rest is exact, and a run keeps its resolution however far and however long it
/// goes.
#pragma once

#include "flight/tolerances.hpp"

#include <carom/scene.hpp>
#include <carom/types.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace carom {

inline constexpr EpochTime never{std::numeric_limits<std::int64_t>::max(), 0};

struct Frame {
    double epoch_length = 1;  ///< [time], a power of two
    double cell_size = 1;     ///< [length], a power of two

    /// to - from [time]; relative error u, plus u times the offsets' difference. Infinite if `to` is never.
    double between(const EpochTime& from, const EpochTime& to) const
    {
        if (to.epoch == never.epoch) return std::numeric_limits<double>::infinity();
        return static_cast<double>(to.epoch - from.epoch) * epoch_length + (to.offset - from.offset);
    }

    /// from + dt, dt >= 0; rounds to the resolution of an offset, u * epoch_length. Never if dt is infinite or beyond
    /// 2^62 epochs.
    EpochTime after(const EpochTime& from, double dt) const
    {
        const double sum = from.offset + dt;
        return sum < epoch_length ? EpochTime{from.epoch, sum} : in_later_epoch(from, dt);
    }

    /// Seconds since the start, rounded to a double [time].
    double seconds(const EpochTime& t) const { return static_cast<double>(t.epoch) * epoch_length + t.offset; }

private:
    EpochTime in_later_epoch(const EpochTime& from, double dt) const;
};

/// Epoch: short enough that u * epoch_length * (highest speed that the energy allows) stays below u * smallest radius;
/// cells: a little above the smallest diameter. Pure functions of the scene.
Frame make_frame(const Scene& scene);

/// A place: cell * cell_size + local + low, 0 <= local < cell_size in each coordinate [length].
struct Place {
    std::int64_t cell[3] = {0, 0, 0};
    double local[3] = {0, 0, 0};
    double low[3] = {0, 0, 0};  ///< what `local` lacks, in certified runs of bodies in free flight; else 0
};

/// Exact, unless a coordinate is beyond 2^62 cells.
Place place_at(const Frame& frame, const Vec3& position);
/// local[k] = sum, in whatever cell that is.
void put_into_cell(const Frame& frame, Place& place, int k, double sum);
/// Move by a displacement and renormalise; rounds to u (|displacement| + cell_size).
inline Place moved(const Frame& frame, const Place& from, const Vec3& displacement)
{
    Place to = from;
    for (int k = 0; k < 3; ++k) {
        const double sum = from.local[k] + displacement[k];
        to.local[k] = sum;
        if (!(sum >= 0 && sum < frame.cell_size)) put_into_cell(frame, to, k, sum);
    }
    return to;
}
/// Rounded to doubles [length].
Vec3 position_of(const Frame& frame, const Place& place);

/// The largest power of two <= x, for finite x > 0.
double power_of_two_below(double x);

}  // namespace carom
