/// \file
/// A contact: two surfaces that touch or overlap, and the gaps from which contacts are made.
#pragma once

#include <carom/scene.hpp>

#include <cmath>

namespace carom::stepping {

struct Contact {
    double gap = 0;              ///< <= 0 when detected [length]
    BodyId a = no_body;          ///< the sphere; of two spheres the smaller id
    BodyId b = no_body;          ///< the other sphere, or Scene::plane_body(p)
    Vec3 normal = Vec3::Zero();  ///< unit, from b to a
};

/// Signed distance of two surfaces and the unit normal along it.
struct Gap {
    double value;  ///< [length]
    Vec3 normal;   ///< from the second to the first
};

/// The test for contact of two spheres: d^2 <= (r_a + r_b)^2, no square root. Everything that looks for pairs uses it,
/// so that all find the same ones.
inline bool overlap(double dx, double dy, double dz, double radius_sum)
{
    return dx * dx + dy * dy + dz * dz <= radius_sum * radius_sum;
}

/// Two spheres. Coincident centres have no normal: x is taken.
inline Gap sphere_gap(const Vec3& pa, const Vec3& pb, double radius_sum)
{
    const Vec3 d = pa - pb;
    const double distance = std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
    return {distance - radius_sum, distance > 0 ? Vec3(d / distance) : Vec3::UnitX()};
}

/// A plane of the scene, as needed for one test.
struct Wall {
    Vec3 normal;            ///< unit
    double offset;          ///< [length]
    double half_thickness;  ///< [length], 0 for a half-space
    bool plate;             ///< two-sided
};

/// Signed distance of p from the plane in the middle of the wall [length].
inline double wall_height(const Wall& wall, const Vec3& p)
{
    const Vec3& n = wall.normal;
    return n.x() * p.x() + n.y() * p.y() + n.z() * p.z() - wall.offset;
}

/// The test for contact of a sphere and a wall: the sign of wall_gap().value.
inline bool overlap(const Wall& wall, const Vec3& p, double radius)
{
    const double height = wall_height(wall, p);
    return (wall.plate ? std::abs(height) - wall.half_thickness : height) - radius <= 0;
}

/// A sphere and a plane. The normal of a plate points to the side on which the centre is now: nothing remembers where
/// it came from.
inline Gap wall_gap(const Wall& wall, const Vec3& p, double radius)
{
    const double height = wall_height(wall, p);
    if (!wall.plate) return {height - radius, wall.normal};
    return {std::abs(height) - wall.half_thickness - radius, height < 0 ? Vec3(-wall.normal) : wall.normal};
}

}  // namespace carom::stepping
