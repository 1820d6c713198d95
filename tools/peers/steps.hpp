/// \file
/// A time stepper around a query of continuous collision detection, as an engine would use it: ask for each step, go to
/// the contact, reflect, finish the step.
#pragma once

#include "tunnel/contestant.hpp"

#include <algorithm>
#include <cmath>

namespace carom::tunnel {

/// Thrown ball and its target, as the query sees them.
struct PeerScene {
    double radius = 0;  ///< of the ball [length]
    Target target = Target::plate;
    double thickness = 0;         ///< of a plate or of the box behind a wall, diameter of a sphere [length]
    Vec3 normal = Vec3::UnitX();  ///< of a plate or a wall
    Vec3 middle = Vec3::Zero();   ///< of the target: the origin, but for the box behind a wall [length]
};

/// Width of the box that stands for a plate [ball's radius and half of the thickness]: throws hit its middle.
inline constexpr double plate_width = 100;

/// Edge of that box along the plate [length].
inline double plate_edge(const PeerScene& scene)
{
    const double thickness = scene.target == Target::wall ? 0 : scene.thickness;
    return plate_width * (scene.radius + thickness / 2);
}

/// \pre the throw is of a cell: ball first, then a sphere, a plate or a wall at the origin
inline PeerScene peer_scene(const Throw& t, double dt)
{
    const double radius = t.scene.spheres[0].radius;
    if (t.scene.spheres.size() > 1) return {radius, Target::sphere, 2 * t.scene.spheres[1].radius, Vec3::UnitX()};
    const Plane& plane = t.scene.planes[0];
    if (plane.thickness) return {radius, Target::plate, *plane.thickness, plane.normal};
    // So deep that a ball which begins a step outside does not come out at its end.
    const double depth = t.scene.spheres[0].velocity.norm() * dt + 2 * radius;
    return {radius, Target::wall, depth, plane.normal, -depth / 2 * plane.normal};
}

/// Direction from the target to a centre [1].
inline Vec3 outward(const PeerScene& scene, const Vec3& centre)
{
    if (scene.target == Target::sphere) return centre.normalized();
    if (scene.target == Target::wall) return scene.normal;
    return scene.normal.dot(centre) < 0 ? Vec3(-scene.normal) : scene.normal;
}

/// \param first_contact (from, velocity, length): the time of contact within [0, length], if the library finds one
template <class Query>
Flown fly_in_steps(const Throw& t, double dt, std::int64_t steps, const PeerScene& scene, const Query& first_contact)
{
    Vec3 place = t.scene.spheres[0].position, velocity = t.scene.spheres[0].velocity;
    Flown flown;
    for (std::int64_t step = 0; step < steps; ++step) {
        const Vec3 start = outward(scene, place);
        double rest = dt;
        // A throw has one contact: whoever has answered it is not asked again while the surfaces still overlap.
        const bool closes = !flown.answered && velocity.dot(start) < 0;
        const std::optional<double> contact = closes ? first_contact(place, velocity, dt) : std::nullopt;
        if (contact) {
            flown.answered = static_cast<double>(step) * dt + *contact;
            place += *contact * velocity;
            rest -= *contact;
            // A plate is left on the side on which the step began; a sphere along the line of centres.
            const Vec3 normal = scene.target == Target::sphere ? outward(scene, place) : start;
            if (const double closing = velocity.dot(normal); closing < 0) velocity -= 2 * closing * normal;
        }
        place += rest * velocity;
        if (step == 1) {  // the second of the two that are judged
            flown.position = place;
            flown.velocity = velocity;
        }
    }
    flown.end_position = place;
    flown.end_velocity = velocity;
    return flown;
}

}  // namespace carom::tunnel
