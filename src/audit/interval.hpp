/// \file
/// The interval between two frames: how each body came into it, how it left, and which touches the flights before it
/// have within it.
#pragma once

#include "audit/touch.hpp"

#include <carom/scene.hpp>

#include <span>
#include <utility>
#include <vector>

namespace carom::audit {

/// A frame with the bound on the error of each place.
struct SeenFrame {
    double time = 0;             ///< [time]
    std::vector<Vec3> places;    ///< by sphere [length]
    std::vector<double> errors;  ///< [length]
};

/// Frames around an interval, two before it and two behind it where there are such.
struct Window {
    std::span<const SeenFrame> frames;
    std::size_t begin = 0;    ///< index of the frame at which the interval begins; it ends at the next one
    bool from_start = false;  ///< the first of the frames is the start of the scene
    double time_error = 0;    ///< of each frame [time]
    /// Largest speeds by sphere that two frames of the trace have shown so far [length/time].
    std::span<const double> fastest;
};

/// Motion of one body in an interval, as frames show it.
enum class Course : std::uint8_t {
    unknown,  ///< no flight before: in contact, or two contacts within few frames
    kept,     ///< it is on the same flight after the interval
    arrived,  ///< it is on its flight at the end of the interval; how it goes on is not known
    changed   ///< it has left its flight
};

/// A body of the scene in flight.
inline Pull pull_of(const Scene& scene)
{
    return {scene.gravity, scene.drag};
}

struct BodyMotion {
    Course course = Course::unknown;
    std::optional<Parabola> before;  ///< given at the begin of the interval
    std::optional<Parabola> after;   ///< given at its end
    Vec3 off = Vec3::Zero();         ///< place at the end of the interval, less that of `before` there [length]
    double off_error = 0;            ///< [length]
    double way = 0;                  ///< within which it may have been aside of its middle place [length]
    bool from_scene = false;         ///< `before` is how the scene begins: fewer than three frames have shown it
    Bend bend = Bend::hidden;        ///< of the frames around the interval
};

struct Interval {
    double begin = 0, end = 0;        ///< [time]
    std::vector<BodyMotion> motions;  ///< by sphere
    /// Spheres of which at least one moves and that might have met, the one that moves first.
    std::vector<std::pair<BodyId, BodyId>> near;
    std::vector<Touch> touches;  ///< of the flights before, certain ones and others
};

/// \pre the window has a frame at the end of the interval
Interval interval_of(const Scene& scene, const Window& window);

}  // namespace carom::audit
