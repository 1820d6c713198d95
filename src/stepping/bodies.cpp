#include "stepping/bodies.hpp"

#include <cmath>

namespace carom::stepping {

Bodies make_bodies(const Scene& scene)
{
    Bodies bodies;
    for (const Sphere& s : scene.spheres) {
        bodies.position.push_back(s.position);
        bodies.velocity.push_back(s.velocity);
        bodies.radius.push_back(s.radius);
        bodies.mass.push_back(s.mass);
        bodies.inverse_mass.push_back(1 / s.mass);
        bodies.material.push_back(s.material);
    }
    return bodies;
}

void accelerate(Bodies& bodies, const Vec3& gravity, double h)
{
    const Vec3 change = h * gravity;
    for (Vec3& v : bodies.velocity) v += change;
}

void move(Bodies& bodies, double h)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.position[i] += h * bodies.velocity[i];
}

std::size_t first_diverged(const Bodies& bodies)
{
    // One sum decides for all: 0 * x is 0 for finite x, else NaN. Only a failure looks at each sphere.
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : bodies.position) sum += 0.0 * p;
    if (sum.x() + sum.y() + sum.z() == 0) return bodies.size();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec3& p = bodies.position[i];
        if (!(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()))) return i;
    }
    return bodies.size();
}

}  // namespace carom::stepping
