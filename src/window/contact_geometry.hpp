/// \file
/// Gap and normal of a contact: the linear bound that keeps two bodies apart.
#pragma once

#include "window/window_problem.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

struct ContactGeometry {
    Vec3 normal = Vec3::UnitZ();  ///< unit, towards a
    double gap = 0;               ///< [length]
};

/// The gap is a convex function of the relative place on each side of a plate, so that gap + normal.(shift) is never
/// above it.
inline ContactGeometry geometry(const WindowPlane& plane, const WindowBody& body)
{
    const double height = plane.normal.dot(body.place) - plane.offset;
    if (!plane.half_thickness) return {plane.normal, height - body.radius};
    if (height < 0) return {-plane.normal, -height - *plane.half_thickness - body.radius};
    return {plane.normal, height - *plane.half_thickness - body.radius};
}

inline ContactGeometry geometry(const WindowBody& a, const WindowBody& b)
{
    const Vec3 apart = a.place - b.place;
    const double distance = std::sqrt(apart.squaredNorm());
    return {apart / distance, distance - (a.radius + b.radius)};
}

inline ContactGeometry geometry(const WindowProblem& problem, const WindowContact& contact)
{
    const WindowBody& a = problem.bodies[static_cast<std::size_t>(contact.a)];
    const auto b = static_cast<std::size_t>(contact.b.index);
    return contact.b.is_plane() ? geometry(problem.planes[b], a) : geometry(a, problem.bodies[b]);
}

/// The smaller radius: what gaps are measured against.
inline double radius_of(const WindowProblem& problem, const WindowContact& contact)
{
    const double a = problem.bodies[static_cast<std::size_t>(contact.a)].radius;
    if (contact.b.is_plane()) return a;
    return std::min(a, problem.bodies[static_cast<std::size_t>(contact.b.index)].radius);
}

}  // namespace carom
