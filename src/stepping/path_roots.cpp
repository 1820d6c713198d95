#include "stepping/path_roots.hpp"

#include "stepping/bracket.hpp"
#include "stepping/damped_turns.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace carom::stepping {

namespace {

/// c[0] + c[1] t + c[2] t^2 + c[3] t^3
using Cubic = std::array<double, 4>;

double value(const Cubic& c, double t)
{
    return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

/// Times in rising order, between 0 and an end.
struct Times {
    std::array<double, 3> at{};
    std::size_t count = 0;

    void add(double t) { at[count++] = t; }
};

/// Whether a polynomial has one sign from 0 to this end for certain, by its constant and the most that the rest can do
/// against it.
bool keeps_sign(const Cubic& c, double end)
{
    const double sign = c[0] < 0 ? -1 : 1;
    double least = std::abs(c[0]);
    double power = end;
    for (std::size_t k = 1; k < c.size(); ++k, power *= end) least += std::min(0.0, sign * c[k]) * power;
    return least > 0;
}

/// Sign changes of a polynomial of this degree in (0, end): one bracket between any two neighbouring roots of
/// its derivative.
Times sign_changes(const Cubic& c, std::size_t degree, double end, std::int64_t& evaluations)
{
    Times times;
    if (degree == 0) return times;
    if (degree == 1) {
        const double t = -c[0] / c[1];
        if (t > 0 && t < end) times.add(t);
        return times;
    }
    const Cubic derivative{c[1], 2 * c[2], 3 * c[3], 0};
    const Times turns = sign_changes(derivative, degree - 1, end, evaluations);
    double from = 0;
    for (std::size_t k = 0; k <= turns.count; ++k) {
        const double to = k < turns.count ? turns.at[k] : end;
        const bool was_negative = value(c, from) < 0;
        if (was_negative != (value(c, to) < 0)) {
            const auto changed = [&](double t) { return (value(c, t) < 0) != was_negative; };
            times.add(bisect(from, to, changed, evaluations).after);
        }
        from = to;
    }
    return times;
}

/// Times since `now` at which the gap turns, on straight paths and parabolas.
Times turns_of_gap(System& system, const PathContacts& contacts, BodyId a, BodyId b, double now)
{
    const StepPaths& paths = contacts.paths;
    const double left = paths.length() - now;
    Vec3 velocity = paths.velocity(system.bodies, a, now), acceleration = paths.bend(a);
    if (system.detector.is_wall(b)) {
        const Vec3& n = system.detector.wall(b).normal;
        const Cubic rate{n.dot(velocity), n.dot(acceleration), 0, 0};
        return sign_changes(rate, rate[1] != 0 ? 1 : 0, left, system.detector.tests);
    }
    const Vec3 between = paths.place(system.bodies, a, now) - paths.place(system.bodies, b, now);
    velocity -= paths.velocity(system.bodies, b, now);
    acceleration -= paths.bend(b);
    const Cubic rate{between.dot(velocity), velocity.squaredNorm() + between.dot(acceleration),
                     1.5 * velocity.dot(acceleration), acceleration.squaredNorm() / 2};
    if (keeps_sign(rate, left)) return {};
    const std::size_t degree = rate[3] != 0 ? 3 : rate[1] != 0 ? 1 : 0;
    return sign_changes(rate, degree, left, system.detector.tests);
}

/// Whether two spheres are too far apart for their speeds to meet in the rest of the substep.
bool are_too_far(const System& system, const PathContacts& contacts, BodyId a, BodyId b, double now)
{
    const StepPaths& paths = contacts.paths;
    const double left = paths.length() - now;
    const Vec3 velocity = paths.velocity(system.bodies, a, now) - paths.velocity(system.bodies, b, now);
    const Vec3 acceleration = paths.bend(a) - paths.bend(b);
    const double reach = (std::sqrt(velocity.squaredNorm()) + std::sqrt(acceleration.squaredNorm()) * left / 2) * left;
    return contacts.gap_at(system, a, b, now).value > reach * (1 + cell_slack);
}

/// The half-space that a sphere at p sees of a wall: what is fast would be beyond a plate at the next look.
Wall side_towards(const Wall& wall, const Vec3& p)
{
    if (!wall.plate) return wall;
    const double sign = wall_height(wall, p) < 0 ? -1 : 1;
    return {sign * wall.normal, sign * wall.offset + wall.half_thickness, 0, false};
}

}  // namespace

std::optional<double> first_contact(System& system, const PathContacts& contacts, BodyId a, BodyId b, double now)
{
    const double end = contacts.paths.length();
    const bool at_wall = system.detector.is_wall(b);
    if (!at_wall && are_too_far(system, contacts, a, b, now)) return {};
    const Wall side =
        at_wall ? side_towards(system.detector.wall(b), contacts.paths.place(system.bodies, a, now)) : Wall{};
    const auto gap = [&](double t) {
        return at_wall ? wall_gap(side, contacts.paths.place(system.bodies, a, t),
                                  system.bodies.radius[static_cast<std::size_t>(a)])
                       : contacts.gap_at(system, a, b, t);
    };
    const auto is_closed = [&](double t) { return gap(t).value <= 0; };
    const auto rate = [&](double t) { return contacts.gap_rate(system, a, b, gap(t).normal, t); };
    const auto first_after_turns = [&](std::span<const double> turns) -> std::optional<double> {
        double from = now;
        for (std::size_t k = 0; k <= turns.size(); ++k) {
            const double to = k < turns.size() ? now + turns[k] : end;
            ++system.detector.tests;
            if (to > from && rate(from + (to - from) / 2) < 0) {
                if (is_closed(from)) return from;
                if (is_closed(to)) {
                    ++system.root_solves;
                    return bisect(from, to, is_closed, system.detector.tests).before;
                }
            }
            from = to;
        }
        return {};
    };
    if (contacts.paths.is_damped()) return first_after_turns(damped_turns(system, contacts, a, b, now));
    const Times turns = turns_of_gap(system, contacts, a, b, now);
    return first_after_turns(std::span(turns.at.data(), turns.count));
}

}  // namespace carom::stepping
