/// \file
/// Plates for engines that know boxes and no plates.
#pragma once

#include <carom/scene.hpp>

#include <algorithm>

namespace carom::peers {

/// Half the edge of a plate [largest distance of a sphere from the origin, and 1]: no scene's sphere gets round it.
inline constexpr double plate_reach = 1000;
/// Half the thickness of a plate without any [radius of the smallest sphere]: boxes need one.
inline constexpr double thinnest_plate = 1e-3;

/// A box about `middle` whose third axis is the plate's normal.
struct PlateBox {
    Vec3 middle = Vec3::Zero();  ///< [length]
    double edge = 0, half = 0;   ///< half extents along the plate and across it [length]
};

/// \pre the plane has a thickness
inline PlateBox plate_box(const Scene& scene, const Plane& plane)
{
    double reach = 1, smallest = scene.spheres.empty() ? 1 : scene.spheres.front().radius;
    for (const Sphere& sphere : scene.spheres) {
        reach = std::max(reach, sphere.position.norm());
        smallest = std::min(smallest, sphere.radius);
    }
    return {plane.offset * plane.normal, plate_reach * reach,
            std::max(*plane.thickness / 2, thinnest_plate * smallest)};
}

}  // namespace carom::peers
