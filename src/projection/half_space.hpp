/// \file
/// Half-spaces that bound the difference of two 3-vectors among many: what contacts are to velocities.
#pragma once

#include <carom/types.hpp>

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace carom {

/// n.(x_a - x_b) + offset >= 0, or n.x_a + offset >= 0 without b.
struct HalfSpace {
    int a = 0;
    std::optional<int> b;
    Vec3 normal = Vec3::Zero();  ///< unit to rounding
    double offset = 0;           ///< [as the vectors]
};

inline double slack(const HalfSpace& h, std::span<const Vec3> x)
{
    const Vec3& a = x[static_cast<std::size_t>(h.a)];
    if (!h.b) return h.normal.dot(a) + h.offset;
    return h.normal.dot(a - x[static_cast<std::size_t>(*h.b)]) + h.offset;
}

/// Length of the half-space's normal in the metric sum |x_k|^2 / w_k, squared.
inline double normal_length2(const HalfSpace& h, std::span<const double> w)
{
    return w[static_cast<std::size_t>(h.a)] + (h.b ? w[static_cast<std::size_t>(*h.b)] : 0);
}

/// x moved by `multiplier` along the half-space's normal in that metric.
inline void push(const HalfSpace& h, std::span<const double> w, double multiplier, std::span<Vec3> x)
{
    x[static_cast<std::size_t>(h.a)] += (w[static_cast<std::size_t>(h.a)] * multiplier) * h.normal;
    if (h.b) x[static_cast<std::size_t>(*h.b)] -= (w[static_cast<std::size_t>(*h.b)] * multiplier) * h.normal;
}

/// A point, a metric and a polyhedron: whoever solves it finds the point of the polyhedron that is nearest.
struct ProjectionProblem {
    std::vector<Vec3> start;
    std::vector<double> w;  ///< > 0, by vector: distance^2 = sum |x_k - start_k|^2 / w_k
    std::vector<HalfSpace> half_spaces;
    double tolerance = 0;  ///< slacks above -tolerance count as satisfied [as the vectors]
};

struct Projection {
    std::vector<Vec3> point;          ///< unique
    std::vector<double> multipliers;  ///< by half-space, >= 0: point = start + sum of pushes; need not be unique
    /// Every slack is above -tolerance, those of multipliers > 0 within it. Otherwise the bound on steps was met, and
    /// the point is start + pushes all the same.
    bool complete = true;
    int steps = 0;  ///< of the solver: half-spaces that became active, Newton steps or sweeps
};

}  // namespace carom
