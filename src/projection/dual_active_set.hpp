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
    /// Not empty: multipliers mu > 0 of the half-spaces listed here have sum mu_i a_i = 0 (unit normals of the metric),
    /// so that no point lies inside all of them (Gordan's alternative).
    std::vector<int> conflict;
};

struct DualActiveSetOptions {
    /// Where the point lies farther away than this (in the metric) the half-spaces count as in conflict, those with a
    /// multiplier above rounding.
    double largest_distance = any_distance;
    /// Slacks above -this, in units of the normal's length in the metric, count as satisfied, too.
    double unit_tolerance = 0;
};

/// Goldfarb and Idnani, A numerically stable dual method for solving strictly convex quadratic programs, Mathematical
/// Programming 27 (1983), https://doi.org/10.1007/BF02591962, with the factors of Daniel et al. (ThinQr). Ours: the
/// final refinement against the slacks of the point itself, and the bound on steps.
DualActiveSetResult dual_active_set(const ProjectionProblem& problem, const DualActiveSetOptions& options = {});

}  // namespace carom
