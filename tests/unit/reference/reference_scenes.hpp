/// \file
/// Small scenes in code, and helpers to read a reference.
#pragma once

#include <carom/scene.hpp>

#include "reference/reference.hpp"

#include <string>
#include <vector>

namespace carom::test {

inline Sphere ball(const std::string& id, const Vec3& x, const Vec3& v, double mass = 1, double radius = 0.1)
{
    Sphere s;
    s.id = id;
    s.radius = radius;
    s.mass = mass;
    s.position = x;
    s.velocity = v;
    return s;
}

inline Plane plane(const std::string& id, const Vec3& normal, double offset)
{
    Plane p;
    p.id = id;
    p.normal = normal;
    p.offset = offset;
    return p;
}

/// One ball above the floor z = 0, at height `h` of its surface, g = 9.81.
inline Scene drop(double h, double restitution, double tangential = 1, const Vec3& v = Vec3::Zero())
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.materials = {Material{"rubber", restitution, tangential, ""}};
    scene.spheres = {ball("ball", {0, 0, 0.125 + h}, v, 1, 0.125)};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    return scene;
}

/// Galperin 2003: wall, light ball at rest, heavy ball coming in.
inline Scene counting_pi(int k)
{
    Scene scene;
    double mass = 1;
    for (int i = 0; i < k; ++i) mass *= 100;
    scene.spheres = {ball("light", {1, 0, 0}, {0, 0, 0}), ball("heavy", {2, 0, 0}, {-1, 0, 0}, mass)};
    scene.planes = {plane("wall", {1, 0, 0}, 0)};
    return scene;
}

/// n^3 spheres of radius 0.1 on a jittered lattice in a box, speeds of order 1, a generator of its own.
inline Scene gas(int n, double spacing, const Vec3& gravity = Vec3::Zero())
{
    Scene scene;
    scene.gravity = gravity;
    std::uint64_t state = 12345;
    const auto draw = [&state] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 11) * 0x1p-53 - 0.5;
    };
    const double jitter = 0.8 * (spacing - 0.2);
    for (int i = 0; i < n * n * n; ++i) {
        Vec3 x(i % n, i / n % n, i / n / n), v;
        for (int c = 0; c < 3; ++c) {
            x[c] = (x[c] + 0.5) * spacing + jitter * draw();
            v[c] = 2 * draw();
        }
        scene.spheres.push_back(ball("s" + std::to_string(i), x, v));
    }
    for (int c = 0; c < 3; ++c) {
        scene.planes.push_back(plane("low" + std::to_string(c), Vec3::Unit(c), 0));
        scene.planes.push_back(plane("high" + std::to_string(c), -Vec3::Unit(c), -n * spacing));
    }
    return scene;
}

/// The state at `until`, where the run gets that far.
inline Reference run_to(const Scene& scene, double until)
{
    const std::vector<double> times{until};
    return make_reference(scene, until, times);
}

inline double energy(const Scene& scene, const std::vector<BodyState>& states)
{
    double sum = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum += scene.spheres[i].mass * (states[i].velocity.squaredNorm() / 2 - scene.gravity.dot(states[i].position));
    return sum;
}

}  // namespace carom::test
