#include "stepping/bodies.hpp"

#include <cmath>

namespace carom::stepping {

Bodies make_bodies(const Scene& scene)
{
    Bodies bodies;
    for (const Sphere& s : scene.spheres) {
        bodies.position.push_back(scene.origin + s.position);
        bodies.velocity.push_back(s.velocity);
        bodies.radius.push_back(s.radius);
        bodies.mass.push_back(s.mass);
        bodies.inverse_mass.push_back(s.fixed ? 0 : 1 / s.mass);
        bodies.material.push_back(s.material);
        if (s.fixed) bodies.fixed.push_back(bodies.size() - 1);
    }
    bodies.origin = scene.origin;
    return bodies;
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

void show_states(const Bodies& bodies, std::vector<BodyState>& states)
{
    states.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
        states[i] = {bodies.position[i] - bodies.origin, bodies.velocity[i], Mode::flying};
    for (const std::size_t i : bodies.fixed) states[i].mode = Mode::fixed;
}

}  // namespace carom::stepping
