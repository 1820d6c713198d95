#include "tunnel/judge.hpp"

#include "study/tolerances.hpp"
#include "tunnel/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::tunnel {

namespace {

/// Whether the answer came when the contact was and left the velocity that it should have.
bool is_right(const Contestant& who, const Throw& t, const Flown& flown, double dt)
{
    const double off = (flown.velocity - t.velocity).norm();
    if (who.is_exact)
        return std::abs(*flown.answered - t.contact_time) <= t.exact_time && off <= exact_velocity * t.speed_change;
    return *flown.answered <= dt && off <= study::right_velocity * t.speed_change;
}

/// Whether a ball that was answered comes out behind the plate all the same, as it does where a spring gives way.
bool passes(const Contestant& who, const Throw& t, double dt)
{
    const auto planes = static_cast<std::size_t>(t.partner) - t.scene.spheres.size();
    if (static_cast<std::size_t>(t.partner) < t.scene.spheres.size()) return false;
    const Plane& plane = t.scene.planes[planes];
    if (!plane.thickness) return false;
    const double steps = std::min(most_steps_to_leave, std::ceil(t.steps_to_pass) + steps_to_leave);
    const Flown flown = who.fly(t, dt, static_cast<std::int64_t>(steps));
    const Sphere& ball = t.scene.spheres[static_cast<std::size_t>(t.body)];
    const double before = plane.normal.dot(ball.position) - plane.offset;
    const double after = plane.normal.dot(flown.end_position) - plane.offset;
    return before * after < 0 && plane_gap(plane, ball, flown.end_position) > 0;
}

}  // namespace

Judgement judge(const Contestant& who, const Throw& t, double dt)
{
    const Flown flown = who.fly(t, dt, study::longest_case);
    const double error = (flown.position - t.position).norm();
    if (!(flown.answered && *flown.answered <= study::audited_steps * dt)) return {Fate::tunnelled, error};
    if (is_right(who, t, flown, dt)) return {Fate::hit, error};
    return {passes(who, t, dt) ? Fate::tunnelled : Fate::wrong, error};
}

}  // namespace carom::tunnel
