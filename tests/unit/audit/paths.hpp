/// \file
/// Traces built by hand: each sphere goes along legs, parabolas that begin where one is told.
#pragma once

#include "audit/audit_trace.hpp"

#include <carom/scene.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace carom::test {

/// A sphere from a time on.
struct Leg {
    double time = 0;
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
};
using Path = std::vector<Leg>;

inline Vec3 place_at(const Path& path, const Vec3& gravity, double time)
{
    const Leg* leg = &path.front();
    for (const Leg& each : path)
        if (each.time <= time) leg = &each;
    const double s = time - leg->time;
    return leg->place + s * leg->velocity + (s * s / 2) * gravity;
}

/// The same under linear drag k > 0: x = x0 + v s + g (t - s) / k and v exp(-k t) + g s, s = (1 - exp(-k t)) / k, also
/// before the first leg.
inline Leg damped_at(const Path& path, const Vec3& gravity, double k, double time)
{
    const Leg* leg = &path.front();
    for (const Leg& each : path)
        if (each.time <= time) leg = &each;
    const long double t = static_cast<long double>(time) - leg->time, s = -std::expm1(-k * t) / k;
    return {time, leg->place + static_cast<double>(s) * leg->velocity + static_cast<double>((t - s) / k) * gravity,
            static_cast<double>(1 - k * s) * leg->velocity + static_cast<double>(s) * gravity};
}

/// Goes on from the last leg at `time` with another velocity.
inline void turn(Path& path, const Vec3& gravity, double time, const Vec3& velocity)
{
    path.push_back({time, place_at(path, gravity, time), velocity});
}

/// Frames in memory, printed with all digits of doubles.
class Frames final : public audit::FrameSource {
public:
    Frames()
    {
        rounding_.places.see("0.12345678901234567");
        rounding_.time = 1e-15;
    }

    std::vector<audit::Frame> frames;

    const audit::TraceRounding& rounding() const override { return rounding_; }
    audit::TraceRounding& rounding() { return rounding_; }
    std::size_t count() const override { return frames.size(); }
    bool next(audit::Frame& frame) override
    {
        if (next_ == frames.size()) return false;
        frame = frames[next_++];
        return true;
    }

private:
    audit::TraceRounding rounding_;
    std::size_t next_ = 0;
};

inline Frames frames_of(const std::vector<Path>& paths, const Vec3& gravity, const std::vector<double>& times)
{
    Frames result;
    for (const double t : times) {
        audit::Frame& frame = result.frames.emplace_back();
        frame.time = t;
        for (const Path& path : paths) frame.places.push_back(place_at(path, gravity, t));
    }
    return result;
}

inline std::vector<double> equal_times(double rate, double until)
{
    std::vector<double> times;
    for (int k = 0; k / rate <= until; ++k) times.push_back(k / rate);
    return times;
}

}  // namespace carom::test
