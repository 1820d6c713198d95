/// \file
/// Facts of a run beside its flights: the scene in its own units, and the contact laws, looked up by
/// code of its own.
#pragma once

#include "verify/plane_gap.hpp"

#include <carom/verify.hpp>

namespace carom::verification {

struct RunData {
    explicit RunData(const RecordedRun& run);

    const RecordedRun& run;
    Units units;
    std::vector<Vec3> accelerations;  ///< [cells/epoch^2]
    std::vector<Wall> walls;
    Vec3 gravity;              ///< [cells/epoch^2]
    double drag = 0;           ///< [1/epoch]
    double closing_speed = 0;  ///< v_c [cells/epoch]
    double window = 0;         ///< tau_p [epochs]
    bool is_lossy = false;     ///< e < 1 somewhere

    /// The rest policy micro: bounces below closing_speed are elastic, and nothing else.
    bool is_micro() const { return window == 0 && closing_speed > 0; }

    BodyId spheres() const { return static_cast<BodyId>(run.spheres.size()); }
    BodyId planes() const { return static_cast<BodyId>(walls.size()); }
    double radius(BodyId body) const { return sphere(body).radius / units.length; }  ///< [cells]
    const RecordedSphere& sphere(BodyId body) const { return run.spheres[static_cast<std::size_t>(body)]; }
    const Wall& wall(int plane) const { return walls[static_cast<std::size_t>(plane)]; }
    Vec3 acceleration(const Path& path) const
    {
        return path.acceleration == own_acceleration ? path.own
                                                     : accelerations[static_cast<std::size_t>(path.acceleration)];
    }
    /// Gravity along a plane, as it should be, and whether `a` is that to rounding.
    bool is_along(const Vec3& a, int plane) const;

    ContactLaw law(BodyId a, BodyId b) const;
};

}  // namespace carom::verification
