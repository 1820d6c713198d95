#include "tunnel/throw.hpp"

#include "study/tolerances.hpp"
#include "tunnel/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace carom::tunnel {

namespace {

Plane upright(const Cell& cell)
{
    Plane plane;
    plane.id = std::string(target_names[static_cast<std::size_t>(cell.target)]);
    plane.normal = {-1, 0, 0};
    if (cell.target == Target::plate) plane.thickness = cell.thickness;
    return plane;
}

Sphere still_sphere(const Cell& cell)
{
    Sphere sphere;
    sphere.id = "sphere";
    sphere.radius = *cell.thickness / 2;
    sphere.fixed = true;
    return sphere;
}

}  // namespace

CellThrows::CellThrows(const Cell& cell) : cell_(cell), reach_(cell.reach())
{
    Sphere ball;
    ball.id = "ball";
    ball.radius = cell.radius;
    ball.velocity = {cell.speed, 0, 0};
    throw_.scene.spheres.push_back(ball);
    if (cell.target == Target::sphere)
        throw_.scene.spheres.push_back(still_sphere(cell));
    else
        throw_.scene.planes.push_back(upright(cell));
    throw_.scene.end_time = study::longest_case * cell.dt;
    throw_.partner = 1;  // the body after the ball: a sphere, or else the first plane
    throw_.exact_time = exact_time * std::min(cell.radius, reach_) / cell.speed;
    throw_.steps_to_pass = 2 * reach_ / (cell.speed * cell.dt);
    // Rounded as the bodies of the scene have it, for the truth is that of the scene.
    if (cell.target == Target::sphere) reach_ = cell.radius + throw_.scene.spheres[1].radius;
}

const Throw& CellThrows::at(const Aim& aim)
{
    const double v = cell_.speed, b = aim.offset * reach_;
    const double chord = std::sqrt((reach_ - b) * (reach_ + b));
    Sphere& ball = throw_.scene.spheres[0];
    ball.position = {-(chord + aim.phase * v * cell_.dt), 0, b};
    throw_.contact_time = (-chord - ball.position.x()) / v;
    // Reflected at the normal (-chord, 0, b) / reach of the contact.
    const double along = chord / reach_, across = b / reach_;
    throw_.velocity = v * Vec3(1 - 2 * along * along, 0, 2 * along * across);
    throw_.speed_change = 2 * v * along;
    throw_.position = Vec3(-chord, 0, b) + (study::audited_steps * cell_.dt - throw_.contact_time) * throw_.velocity;
    return throw_;
}

std::uint64_t stream_of(const Cell& cell)
{
    std::uint64_t hash = hash_basis;
    const auto fold = [&](std::uint64_t word) { hash = (hash ^ word) * hash_prime; };
    fold(static_cast<std::uint64_t>(cell.target));
    for (const double each : {cell.thickness.value_or(-1), cell.radius, cell.dt, cell.speed})
        fold(std::bit_cast<std::uint64_t>(each));
    return hash;
}

}  // namespace carom::tunnel
