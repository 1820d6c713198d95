/// \file
/// What the verifier knows of a run beside its flights: the scene in its own units, and the contact laws, looked up by
/// code of its own.
#pragma once

#include "verify/plane_gap.hpp"

#include <carom/verify.hpp>

#include <unordered_map>

namespace carom::verification {

struct RunData {
    explicit RunData(const RecordedRun& run);

    const RecordedRun& run;
    Units units;
    std::vector<double> radii;        ///< [cells]
    std::vector<Vec3> accelerations;  ///< [cells/epoch^2]
    std::vector<Wall> walls;
    Vec3 gravity;  ///< [cells/epoch^2]

    BodyId spheres() const { return static_cast<BodyId>(radii.size()); }
    BodyId planes() const { return static_cast<BodyId>(walls.size()); }
    double radius(BodyId body) const { return radii[static_cast<std::size_t>(body)]; }
    const RecordedSphere& sphere(BodyId body) const { return run.spheres[static_cast<std::size_t>(body)]; }
    const Wall& wall(int plane) const { return walls[static_cast<std::size_t>(plane)]; }
    const Vec3& acceleration(const Path& path) const
    {
        return accelerations[static_cast<std::size_t>(path.acceleration)];
    }
    /// Gravity along a plane, as it should be, and whether `a` is that to rounding.
    bool is_along(const Vec3& a, int plane) const;
    /// Which entry of the table is this, to the bit? -1: none.
    std::int32_t index_of(const Vec3& acceleration) const;

    ContactLaw law(BodyId a, BodyId b) const;
};

/// The flight that each sphere is on.
struct Flights {
    std::vector<Path> paths;
    std::unordered_map<BodyId, SeriesRecord> series;  ///< of those whose mode says so [cells], [epochs]

    Path& path(BodyId body) { return paths[static_cast<std::size_t>(body)]; }
    const Path& path(BodyId body) const { return paths[static_cast<std::size_t>(body)]; }
};

}  // namespace carom::verification
