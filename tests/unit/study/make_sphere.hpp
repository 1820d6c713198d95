#pragma once

#include <carom/scene.hpp>

/// A sphere for tests: what is not said has its default.
inline carom::Sphere make_sphere(const char* id, double radius, const carom::Vec3& position = carom::Vec3::Zero())
{
    carom::Sphere sphere;
    sphere.id = id;
    sphere.radius = radius;
    sphere.position = position;
    return sphere;
}
