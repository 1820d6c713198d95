/// \file
/// How near a sphere comes to a plane during one flight.
#pragma once

#include "verify/pair_gap.hpp"

#include <carom/scene.hpp>

namespace carom::verification {

/// A plane in the verifier's units, and the side on which the sphere is.
struct Wall {
    Vec3 normal = Vec3::UnitZ();  ///< as recorded: the gap is normal.x - offset - r, whatever the length of the normal
    double offset = 0;            ///< [cells]
    double half_thickness = 0;    ///< [cells], of a plate
    bool is_plate = false;
};

struct WallSegment {
    const Path& path;
    const Vec3& acceleration;  ///< [cells/epoch^2]
    const Wall& wall;
    double side;  ///< 1, or -1 behind a plate
    EpochTime from, to;
    double radius;  ///< [cells]
    /// Flight at the start of a sphere that overlapped then.
    const Path* initial = nullptr;
};

// As for pairs.
bool is_clear(const WallSegment& segment, double smallest);
GapFound examine(const WallSegment& segment, double bound);

/// 1, or -1 behind a plate.
double side_of(const Wall& wall, const Path& path);

/// The largest |gap| from `from` to `to`, an upper bound [cells].
double largest_distance(const WallSegment& segment);

/// side (n.x - offset) - thickness/2 - r at a time, in double-double [cells].
DoubleDouble height(const WallSegment& segment, const EpochTime& at);

}  // namespace carom::verification
