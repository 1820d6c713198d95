/// \file
/// Moments as certified runs need them: roundings to one side.
#pragma once

#include "motion/number.hpp"
#include "motion/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

/// The time one step of the resolution before t, but not before `from`.
inline EpochTime step_back(const Frame& frame, const EpochTime& from, const EpochTime& t)
{
    EpochTime back = t;
    if (back.offset > 0) {
        back.offset = std::max(0.0, back.offset - time_resolution * frame.epoch_length);
        if (back.offset == t.offset) back.offset = std::nextafter(t.offset, 0.0);
    } else {
        back = {t.epoch - 1, std::nextafter(frame.epoch_length, 0.0)};
    }
    return std::max(back, from);
}

/// A time well before from + t, by roundings; the exact contact is not before from + t.
inline EpochTime rough_time(const Frame& frame, const EpochTime& from, double t)
{
    EpochTime time = frame.after(from, t);
    for (int i = 0; i < rough_steps && from < time && time != never; ++i) time = step_back(frame, from, time);
    return time;
}

/// The time t + by, `by` of either sign and below 2^52 epochs.
inline EpochTime shifted(const Frame& frame, const EpochTime& t, double by)
{
    const double sum = t.offset + by, whole = std::floor(sum / frame.epoch_length);
    const double offset = std::max(0.0, sum - whole * frame.epoch_length);
    return {t.epoch + static_cast<std::int64_t>(whole), std::min(offset, std::nextafter(frame.epoch_length, 0.0))};
}

/// The latest time, to the resolution or a few of its steps, not after from + t.
inline EpochTime no_later(const Frame& frame, const EpochTime& from, DoubleDouble t)
{
    EpochTime time = frame.after(from, t.high);
    if (time == never) return time;
    // After a long wait the last bit of t.high is many steps of the resolution.
    const DoubleDouble rest = t - elapsed<DoubleDouble>(frame, from, time);
    if (std::abs(rest.high) > time_resolution * frame.epoch_length)
        time = std::max(from, shifted(frame, time, rest.high));
    for (int i = 0; i < most_late_steps && from < time && elapsed<DoubleDouble>(frame, from, time) > t; ++i)
        time = step_back(frame, from, time);
    return time;
}

}  // namespace carom
