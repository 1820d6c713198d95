/// \file
/// The point of a polyhedron that is nearest to a given one: a strictly convex quadratic program. Finite, exact to
/// rounding, and at ease with half-spaces that depend on each other. Costs grow with the cube of what is active: for up
/// to some hundred half-spaces.
#pragma once

#include "projection/half_space.hpp"
#include "projection/tolerances.hpp"

namespace carom {

struct DualActiveSetResult {
    Projection projection;
    /// Half-spaces in conflict, or empty: multipliers mu > 0 of those listed have sum mu_i a_i = 0 (unit normals of the
    /// metric), so that no point lies inside all of them (Gordan's alternative).
    std::vector<int> conflict;
};

struct DualActiveSetOptions {
    /// Distance of the point, in the metric, beyond which the half-spaces with a multiplier above rounding count as in
    /// conflict.
    double largest_distance = any_distance;
    /// Negative slack that counts as satisfied, too, in units of the normal's length in the metric.
    double unit_tolerance = 0;
};

/// Goldfarb and Idnani, A numerically stable dual method for solving strictly convex quadratic programs, Mathematical
/// Programming 27 (1983), https://doi.org/10.1007/BF02591962, with the factors of Daniel et al. (ThinQr). This
/// project's: the final refinement against the slacks of the point itself, and the bound on steps.
DualActiveSetResult dual_active_set(const ProjectionProblem& problem, const DualActiveSetOptions& options = {});

}  // namespace carom
