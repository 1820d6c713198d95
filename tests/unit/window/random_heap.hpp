/// \file
/// Crowds of balls without overlap, with all their contacts, drawn at random.
#pragma once

#include "support/random.hpp"
#include "window/contact_geometry.hpp"

#include <vector>

namespace carom::test {

inline void list_all_contacts(WindowProblem& problem, double restitution)
{
    problem.contacts.clear();
    for (std::size_t i = 0; i < problem.bodies.size(); ++i) {
        for (std::size_t j = i + 1; j < problem.bodies.size(); ++j)
            problem.contacts.push_back({static_cast<int>(i), Partner::sphere(static_cast<BodyId>(j)), restitution, 0});
        for (std::size_t p = 0; p < problem.planes.size(); ++p)
            problem.contacts.push_back({static_cast<int>(i), Partner::plane(static_cast<int>(p)), restitution, 0});
    }
}

/// Balls of radii 1 to 2 in a box without lid, some in touch, with speeds of about 1 under gravity 1, one in eight
/// fixed.
inline WindowProblem random_heap(Random& random, int balls)
{
    constexpr double side = 8;
    WindowProblem out;
    out.planes = {{Vec3::UnitZ(), 0, {}},
                  {Vec3::UnitX(), 0, {}},
                  {-Vec3::UnitX(), -side, {}},
                  {Vec3::UnitY(), 0, {}},
                  {-Vec3::UnitY(), -side, {}}};
    for (int i = 0; i < balls; ++i) {
        WindowBody ball;
        ball.radius = random.uniform(1, 2);
        const double x = random.uniform(ball.radius, side - ball.radius);
        const double y = random.uniform(ball.radius, side - ball.radius);
        // Let down until it touches what lies below.
        double z = ball.radius;
        for (const WindowBody& other : out.bodies) {
            const double across = Vec3(x - other.place.x(), y - other.place.y(), 0).squaredNorm();
            const double reach = ball.radius + other.radius;
            if (across < reach * reach) z = std::max(z, other.place.z() + std::sqrt(reach * reach - across));
        }
        ball.place = Vec3(x, y, z * (1 + 1e-15) + (random.coin() ? random.uniform(0, 0.01) : 0));
        ball.velocity = random.in_cube(1);
        ball.acceleration = -Vec3::UnitZ();
        ball.inverse_mass = 1 / random.log_uniform(0.1, 10);
        if (random.integer(0, 7) == 0) {
            ball.inverse_mass = 0;
            ball.velocity = ball.acceleration = Vec3::Zero();
        }
        out.bodies.push_back(ball);
    }
    list_all_contacts(out, random.uniform(0, 1));
    return out;
}

}  // namespace carom::test
