/// \file
/// Half-spaces that bound the difference of two 3-vectors among many: what contacts are to velocities.
#pragma once

#include "projection/tolerances.hpp"

#include <carom/types.hpp>

#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace carom {

/// The half-space n.(x_a - x_b) + offset >= 0, or n.x_a + offset >= 0 without b; or the plane that bounds it.
struct HalfSpace {
    int a = 0;
    std::optional<int> b;
    Vec3 normal = Vec3::Zero();  ///< unit to rounding
    double offset = 0;           ///< [as the vectors]
    bool is_equality = false;    ///< the plane alone: its multiplier may have either sign
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

/// Moves x by `multiplier` along the half-space's normal in that metric.
inline void push(const HalfSpace& h, std::span<const double> w, double multiplier, std::span<Vec3> x)
{
    x[static_cast<std::size_t>(h.a)] += (w[static_cast<std::size_t>(h.a)] * multiplier) * h.normal;
    if (h.b) x[static_cast<std::size_t>(*h.b)] -= (w[static_cast<std::size_t>(*h.b)] * multiplier) * h.normal;
}

/// A point, a metric and a polyhedron. The solution is the point of the polyhedron that is nearest to the start.
struct ProjectionProblem {
    std::vector<Vec3> start;
    std::vector<double> w;  ///< > 0, by vector: distance^2 = sum |x_k - start_k|^2 / w_k
    std::vector<HalfSpace> half_spaces;
    double tolerance = 0;  ///< slacks above -tolerance count as satisfied [as the vectors]
    /// Length of the part of a unit normal off the active ones below which it depends on them [1]
    double dependent = dependent_normal;
};

struct Projection {
    std::vector<Vec3> point;  ///< unique
    std::vector<double>
        multipliers;  ///< by half-space, >= 0 but at equalities: point = start + sum of pushes; not always unique
    /// Whether every slack is above -tolerance, those of multipliers > 0 within it. Otherwise the bound on steps was
    /// met, and the point is start + pushes all the same.
    bool complete = true;
    int steps = 0;  ///< of the solver: half-spaces that became active, Newton steps or sweeps
    /// Half-spaces that no point is inside of: with multipliers mu > 0 of these, and some of the equalities, sum mu_i
    /// a_i = 0 (Farkas). Told by the dense solver alone, of those that it came across.
    std::vector<int> bound{};
};

}  // namespace carom
