/// \file
/// Events with which bodies leave what the broad phase knows of them: a cell of the grid, or the ball in which lists of
/// neighbours hold.
#pragma once

#include "broad/neighbour_lists.hpp"
#include "motion/relative.hpp"
#include "predict/tracks.hpp"
#include "queue/key.hpp"
#include "toi/damped_plane.hpp"
#include "toi/sphere_plane.hpp"

#include <limits>

namespace carom {

// The event with which a body leaves; its time is `never` if it does not. `own` is the track of the body now.

/// The crossing of a cell wall.
template <class Kinematics>
Key leaving(const State& state, const CellGrid& grid, BodyId body, const Track&, const EpochTime& now, const EpochTime&)
{
    constexpr bool gravity = Kinematics::has_gravity;
    Flight f;
    if constexpr (gravity) {
        f = filed_path(state, body, now);
    } else {
        const Flight& own = state.flight(body);
        f.velocity = own.velocity;
        f.place = moved(state.frame, own.place, state.frame.between(own.start, now) * own.velocity);
    }
    double soonest = std::numeric_limits<double>::infinity();
    Partner wall;
    const auto keep_wall = [&](const Root& root, int axis, bool upper) {
        // Starting to fall on the wall itself (pressed) is leaving, too.
        if (root.kind == RootKind::none || !(root.t < soonest)) return;
        soonest = root.t;
        wall = Partner::cell_wall(axis, upper);
    };
    for (int axis = 0; axis < 3; ++axis) {
        const double v = f.velocity[axis], g = gravity ? state.acceleration(f)[axis] : 0;
        const double slack = gravity ? grid.slack() : 0;
        const auto root = [&](double height, double speed, double pull) {
            if constexpr (Kinematics::has_drag)
                return damped_plane_root(height + slack, speed, pull, state.drag);
            else
                return gravity ? plane_root(height + slack, speed, pull) : uniform_plane_root(height, speed);
        };
        if (v < 0 || g < 0) keep_wall(root(grid.above_lower_wall(state.frame, body, axis, f.place), v, g), axis, false);
        if (v > 0 || g > 0)
            keep_wall(root(grid.below_upper_wall(state.frame, body, axis, f.place), -v, -g), axis, true);
    }
    if (!(soonest < std::numeric_limits<double>::infinity())) return {};
    return {state.frame.after(now, soonest), Scheduled::cell_crossing, body, wall};
}

/// A time within which a body certainly stays within `radius` of the centre from which it is `from` away now [time].
/// Drag only shortens its way.
inline double time_within(const Vec3& from, const Vec3& v, double acceleration, double radius)
{
    const auto straight = [&](double r) {
        const double a = v.squaredNorm(), b = from.dot(v), c = r * r - from.squaredNorm();
        if (!(a > 0)) return std::numeric_limits<double>::infinity();
        if (c <= 0) return 0.0;
        const double root = std::sqrt(b * b + a * c);
        return b > 0 ? c / (root + b) : (root - b) / a;
    };
    if (acceleration == 0) return straight(radius);
    return std::min(straight(radius * (1 - bent_part)), std::sqrt(2 * bent_part * radius / acceleration));
}

/// The escape from the ball around where the body was filed. \param limit escapes after it need not be found
template <class Kinematics>
Key leaving(const State& state, const NeighbourLists& lists, BodyId body, const Track& own, const EpochTime& now,
            const EpochTime& limit)
{
    const Vec3& centre = lists.centre(body);
    const double radius = lists.escape_radius();
    Vec3 from, v;
    double acceleration = 0;
    if (own.is_parabola) {
        from = Vec3(own.place[0], own.place[1], own.place[2]) - centre;
        v = Vec3(own.velocity[0], own.velocity[1], own.velocity[2]);
        if (own.acceleration == Accelerations::none) {
            const double dt = state.frame.between(now, limit);
            if (limit != never && (from + dt * v).squaredNorm() < radius * radius) return {};  // on its way, too
        } else {
            acceleration = length(state.bodies.accelerations()[own.acceleration]);
        }
    } else {
        const Flight f = filed_path(state, body, now);
        from = separation(state.frame, f.place, lists.origin()) - centre;
        v = f.velocity;
        acceleration = length(state.acceleration(f));
    }
    const double time = time_within(from, v, acceleration, radius);
    if (!(time < std::numeric_limits<double>::infinity())) return {};
    return {state.frame.after(now, time), Scheduled::cell_crossing, body, {}};
}

}  // namespace carom
