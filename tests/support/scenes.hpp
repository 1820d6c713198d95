/// \file
/// Scenes for tests, built in code so that a test shows everything it depends on.
#pragma once

#include "support/random.hpp"

#include <carom/simulate.hpp>

#include <string>
#include <utility>
#include <vector>

namespace carom::test {

inline const Vec3 earth{0, 0, -9.81};

inline Scene empty_scene(double end_time, const Vec3& gravity = Vec3::Zero(), double restitution = 1)
{
    Scene scene;
    scene.end_time = end_time;
    scene.gravity = gravity;
    scene.materials[0].restitution = restitution;
    return scene;
}

inline void add_sphere(Scene& scene, double radius, const Vec3& position, const Vec3& velocity = Vec3::Zero(),
                       double mass = 1)
{
    Sphere s;
    s.id = "s" + std::to_string(scene.spheres.size());
    s.radius = radius;
    s.mass = mass;
    s.position = position;
    s.velocity = velocity;
    scene.spheres.push_back(s);
}

inline void add_plane(Scene& scene, const std::string& id, const Vec3& normal, double offset = 0)
{
    Plane p;
    p.id = id;
    p.normal = normal.normalized();
    p.offset = offset;
    scene.planes.push_back(p);
}

/// The level floor z = 0.
inline void add_floor(Scene& scene)
{
    add_plane(scene, "floor", Vec3::UnitZ());
}

/// Six walls around [0, side]^3.
inline void add_box(Scene& scene, double side)
{
    const char* names[] = {"x", "y", "z"};
    for (int k = 0; k < 3; ++k) {
        add_plane(scene, std::string("low ") + names[k], Vec3::Unit(k), 0);
        add_plane(scene, std::string("high ") + names[k], -Vec3::Unit(k), -side);
    }
}

/// `count` spheres fall into a shaft of 0.18 x 0.18 and settle there, three on a layer; e = 0.3.
inline Scene shaft(std::uint64_t seed, int count, double end_time)
{
    Scene scene = empty_scene(end_time, earth, 0.3);
    constexpr double width = 0.18;
    add_floor(scene);
    for (int axis = 0; axis < 2; ++axis) {
        add_plane(scene, axis == 0 ? "left" : "front", Vec3::Unit(axis), 0);
        add_plane(scene, axis == 0 ? "right" : "back", -Vec3::Unit(axis), -width);
    }
    Random random(seed);
    for (int k = 0; k < count; ++k) {
        const double r = random.uniform(0.028, 0.034), x = random.uniform(r, width - r),
                     y = random.uniform(r, width - r);
        add_sphere(scene, r, {x, y, 0.05 + 0.08 * k});
    }
    return scene;
}

/// Slides down, is hit, bounces in a series, rests: every mode.
inline Scene every_mode()
{
    Scene scene = empty_scene(6, earth, 0.7);
    scene.materials[0].tangential = 0.9;
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 1.1}, {0.3, 0, 0});
    add_sphere(scene, 0.2, {3, 0, 0.2}, {-0.5, 0, 0}, 2);
    add_sphere(scene, 0.3, {-4, 0, 0.3});
    scene.spheres.back().fixed = true;
    return scene;
}

/// `count` spheres at random in [0, side]^3, clear of each other and of the walls; masses as volumes.
inline void fill_box(Scene& scene, Random& random, int count, double side, double r_min, double r_max, double speed)
{
    for (int tries = 0; static_cast<int>(scene.spheres.size()) < count && tries < 1000 * count; ++tries) {
        const double r = random.uniform(r_min, r_max);
        const Vec3 p = Vec3::Constant(side / 2) + random.in_cube(side / 2 - 1.01 * r);
        const Vec3 v = random.in_cube(speed);
        bool clear = true;
        for (const auto& s : scene.spheres) clear = clear && (s.position - p).norm() > 1.01 * (s.radius + r);
        if (clear) add_sphere(scene, r, p, v, r * r * r);
    }
}

/// A gas in a box.
inline Scene gas(std::uint64_t seed, int count, double end_time, const Vec3& gravity = Vec3::Zero(),
                 double restitution = 1, double r_min = 0.3, double r_max = 0.5, double side = 10)
{
    Scene scene = empty_scene(end_time, gravity, restitution);
    Random random(seed);
    add_box(scene, side);
    fill_box(scene, random, count, side, r_min, r_max, 3);
    return scene;
}

inline double kinetic_energy(const Scene& scene, const std::vector<BodyState>& states)
{
    double energy = 0;
    for (std::size_t i = 0; i < states.size(); ++i)
        energy += 0.5 * scene.spheres[i].mass * states[i].velocity.squaredNorm();
    return energy;
}

/// Kinetic and potential.
inline double energy(const Scene& scene, const std::vector<BodyState>& states)
{
    double total = kinetic_energy(scene, states);
    for (std::size_t i = 0; i < states.size(); ++i)
        total -= scene.spheres[i].mass * scene.gravity.dot(states[i].position);
    return total;
}

inline std::vector<BodyState> initial_states(const Scene& scene)
{
    std::vector<BodyState> states;
    for (const auto& s : scene.spheres) states.push_back({s.position, s.velocity, Mode::flying});
    return states;
}

/// A run with all its events, guarded against hanging.
struct Recorded {
    Outcome outcome;
    std::vector<Event> events;
};
inline Recorded record(const Scene& scene, const Method& method = EventDriven{}, RunOptions options = {})
{
    Recorded run;
    if (!(options.max_seconds < 20)) options.max_seconds = 20;
    Observer observer;
    observer.on_event = [&](const Event& e) { run.events.push_back(e); };
    run.outcome = simulate(scene, method, options, observer);
    return run;
}

}  // namespace carom::test
