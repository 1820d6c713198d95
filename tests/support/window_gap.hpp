/// \file
/// Lowest gap of two bodies in a window, from their motions alone: shares nothing with src/window but its values.
#pragma once

#include "window/window_problem.hpp"

#include <algorithm>
#include <cmath>

namespace carom::test {

/// Lowest |apart + t velocity + t^2 acceleration / 2| for 0 <= t <= length: in closed form for uniform motion,
/// otherwise the lowest of pieces, each searched by thirds.
inline double least_distance(const Vec3& apart, const Vec3& velocity, const Vec3& acceleration, double length)
{
    const auto distance = [&](double t) { return (apart + t * (velocity + (t / 2) * acceleration)).norm(); };
    if (acceleration.squaredNorm() == 0) {
        const double square = velocity.squaredNorm();
        return distance(square > 0 ? std::clamp(-apart.dot(velocity) / square, 0.0, length) : 0);
    }
    double out = std::min(distance(0), distance(length));
    constexpr int pieces = 8, thirds = 60;
    for (int k = 0; k < pieces; ++k) {
        double low = length * k / pieces, high = length * (k + 1) / pieces;
        for (int i = 0; i < thirds; ++i) {
            const double third = (high - low) / 3;
            if (distance(low + third) < distance(high - third))
                high -= third;
            else
                low += third;
        }
        out = std::min(out, distance((low + high) / 2));
    }
    return out;
}

inline double least_gap(const WindowBody& a, const WindowMotion& of_a, const WindowBody& b, const WindowMotion& of_b,
                        double length)
{
    return least_distance(a.place - b.place, of_a.velocity - of_b.velocity, of_a.acceleration - of_b.acceleration,
                          length) -
           (a.radius + b.radius);
}

inline double least_gap(const WindowBody& a, const WindowMotion& of_a, const WindowPlane& plane, double length)
{
    const double height = plane.normal.dot(a.place) - plane.offset, first = plane.normal.dot(of_a.velocity),
                 second = plane.normal.dot(of_a.acceleration);
    const double side = plane.half_thickness && height < 0 ? -1 : 1;
    const auto at_time = [&](double t) { return side * (height + t * (first + t * second / 2)); };
    double out = std::min(at_time(0), at_time(length));
    if (second != 0) out = std::min(out, at_time(std::clamp(-first / second, 0.0, length)));
    return out - (plane.half_thickness ? *plane.half_thickness : 0.0) - a.radius;
}

}  // namespace carom::test
