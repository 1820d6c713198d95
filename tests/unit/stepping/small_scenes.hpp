/// \file
/// Scenes of a few lines for the tests of the discrete methods.
#pragma once

#include <carom/scene.hpp>

#include <cstdint>
#include <random>
#include <string>

namespace carom::test {

inline Sphere ball(double radius, const Vec3& position, const Vec3& velocity = Vec3::Zero(), double mass = 1)
{
    Sphere s;
    s.radius = radius;
    s.mass = mass;
    s.position = position;
    s.velocity = velocity;
    return s;
}

inline Plane wall(const Vec3& normal, double offset)
{
    Plane p;
    p.normal = normal;
    p.offset = offset;
    return p;
}

inline Plane plate(const Vec3& normal, double offset, double thickness)
{
    Plane p = wall(normal, offset);
    p.thickness = thickness;
    return p;
}

inline Scene scene_of(std::vector<Sphere> spheres, std::vector<Plane> planes = {}, const Vec3& gravity = Vec3::Zero())
{
    Scene scene;
    scene.end_time = 1;
    scene.gravity = gravity;
    scene.spheres = std::move(spheres);
    scene.planes = std::move(planes);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) scene.spheres[i].id = "sphere-" + std::to_string(i);
    return scene;
}

/// n spheres of radius 0.1 on each other on a floor, under 9.81.
inline Scene tower(int n, double restitution)
{
    std::vector<Sphere> spheres;
    for (int k = 0; k < n; ++k) spheres.push_back(ball(0.1, Vec3(0, 0, 0.1 + 0.2 * k)));
    Scene scene = scene_of(std::move(spheres), {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    scene.materials[0].restitution = restitution;
    return scene;
}

/// In [0, 1), the same on every standard library.
inline double uniform(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

inline Vec3 uniform_vector(std::mt19937_64& random, double low, double high)
{
    const double x = uniform(random);
    const double y = uniform(random);
    const double z = uniform(random);
    return Vec3::Constant(low) + (high - low) * Vec3(x, y, z);
}

/// Elastic spheres without overlap in a cube [0, side]^3 with walls.
inline Scene gas(std::size_t n, double radius, double side, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    std::vector<Sphere> spheres;
    while (spheres.size() < n) {
        const Vec3 p = uniform_vector(random, radius, side - radius);
        bool is_free = true;
        for (const Sphere& s : spheres) is_free = is_free && (s.position - p).squaredNorm() > 4 * radius * radius;
        if (is_free) spheres.push_back(ball(radius, p, uniform_vector(random, -1, 1)));
    }
    std::vector<Plane> walls;
    for (int axis = 0; axis < 3; ++axis) {
        walls.push_back(wall(Vec3::Unit(axis), 0));
        walls.push_back(wall(-Vec3::Unit(axis), -side));
    }
    return scene_of(std::move(spheres), std::move(walls));
}

}  // namespace carom::test
