/// \file
/// Series of bounces as the verifier sees them: where the ball is inside one, and the ball that all of it stays in.
#pragma once

#include "verify/path.hpp"

#include <optional>

namespace carom::verification {

/// Inside a series, bounce by bounce [cells], [epochs].
struct InSeries {
    Vec3 shift, velocity;  ///< since the start of the series
    bool ended = false;    ///< all bounces are over
};

/// \param normal of the plane, towards the ball. None if there are too many bounces to follow one by one.
std::optional<InSeries> inside(const SeriesRecord& series, const Vec3& normal, double tau);

inline double duration(const SeriesRecord& s)
{
    return 2 * s.normal_speed / s.gravity / (1 - s.restitution);
}

/// A flight of a larger ball that a ball in a series never leaves.
struct Swept {
    Path path;
    double radius = 0;  ///< [cells]
};
/// \param normal of the plane, towards the ball
Swept swept(const Path& path, double radius, const SeriesRecord& series, const Vec3& normal);

}  // namespace carom::verification
