/// \file
/// Small scenes from a few numbers.
#pragma once

#include <carom/scene.hpp>

#include <string>

namespace carom::stress {

inline Scene empty_scene(const std::string& name, double end_time, const Vec3& gravity = Vec3::Zero(),
                         double restitution = 1)
{
    Scene scene;
    scene.name = name;
    scene.end_time = end_time;
    scene.gravity = gravity;
    scene.materials[0].restitution = restitution;
    return scene;
}

/// What these cases say of a sphere.
struct Ball {
    double radius = 1, mass = 1;  ///< > 0
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
};

inline void add_sphere(Scene& scene, const Ball& ball)
{
    Sphere sphere;
    sphere.id = "sphere-" + std::to_string(scene.spheres.size());
    sphere.radius = ball.radius;
    sphere.mass = ball.mass;
    sphere.position = ball.position;
    sphere.velocity = ball.velocity;
    scene.spheres.push_back(sphere);
}

/// \param normal of unit length
inline void add_plane(Scene& scene, const Vec3& normal, double offset = 0)
{
    Plane plane;
    plane.id = "plane-" + std::to_string(scene.planes.size());
    plane.normal = normal;
    plane.offset = offset;
    scene.planes.push_back(plane);
}

/// Six walls around [0, side]^3.
inline void add_box(Scene& scene, double side)
{
    for (int axis = 0; axis < 3; ++axis) {
        add_plane(scene, Vec3::Unit(axis), 0);
        add_plane(scene, -Vec3::Unit(axis), -side);
    }
}

}  // namespace carom::stress
