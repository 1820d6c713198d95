/// \file
/// The tolerances of the solvers of projections: unit, value, reason. "Measured" is what carom_projection_bench prints
/// for piles of 8 to 1000 spheres (tests/bench/projections.cpp), also with the value changed. Slacks are seen against
/// ProjectionProblem::tolerance, in problems of contacts 1e-13 of the largest speed, unit normals against 1.
#pragma once

#include "math/tolerances.hpp"

#include <cstddef>

namespace carom {

// The choice of the solver (project.hpp).

/// Half-spaces [1] up to which the dense active set solves a part: it is exact to rounding and at ease with dependent
/// ones. Measured: with 28 it takes as long as sparse factors, with 82 two to five times as long, 0.2 ms.
inline constexpr std::size_t dense_limit = 80;
/// The same where there is a guess [1]. Measured: one heap takes 2.4 s with 4, 12 or 28 of them, and 5.0 s with 80.
inline constexpr std::size_t guessed_limit = 12;
/// Sweeps [1] of Gauss-Seidel before a sparse active set: enough to tell most active half-spaces from the others.
/// Measured: of 20 piles, sets that begin from 30 sweeps do not settle in 3, from 3 or 10 sweeps in 4 and 3, and from
/// 100 sweeps, which take as long as the set does, in 2.
inline constexpr int first_sweeps = 30;
/// Sweeps [1] after a set that did not settle, before another one. Measured: of 16 piles one needs them, once.
inline constexpr int more_sweeps = 100;
/// Sets [1] that are tried so: the one of 16 piles above needs two. No derivation of the others.
inline constexpr int most_sets = 4;
/// Half-spaces [1] up to which the dense active set solves what no sparse one has: 634 take 0.1 s.
inline constexpr std::size_t largest_dense = 1000;
/// Sweeps [1] for what no solver finishes: none makes it worse. Measured: 40 to 70 ms for 3,000 half-spaces.
inline constexpr int last_sweeps = 1000;

// Dual active set (dual_active_set.cpp).

/// Length [1] of the part of a unit normal off the active ones below which it depends on them: twice the root of u.
/// Directions are known to u / length only: one of 2e-8 is off by 6e-9, and of shorter ones the next dependent
/// direction looks independent. A mass ratio of 1e9 makes 3e-5. A wedge of spheres of like size that is so narrow is
/// passed with an overlap of 1e-15 of their radii; planes make none (`narrowest_wedge`).
inline constexpr double dependent_normal = 2e-8;
/// Slack [tolerances] that a dependent normal may miss without being in conflict with those that it depends on: with
/// tolerances of 1e-13 of the sizes that occur, 4e-8 of these, twice `dependent_normal`.
inline constexpr double missed_by_dependent = 4e5;
/// The same [tolerances of units]: a hundredth of the openings of 1 that are asked for to within 1e-6. It was set for
/// dependent normals of 1e-10 and ways of 1e7, and not again since.
inline constexpr double missed_units_by_dependent = 1e4;
/// Distance [length in the metric] of a point without conflict, by default: any, for its square is infinite.
inline constexpr double any_distance = 0x1p1000;
/// Rounds [1] of refinement against the point's own slacks, and of active sets after it: each leaves of what it mends
/// u / `dependent_normal`^2 = 0.3 at worst, most often rounding.
inline constexpr int dual_refinements = 2;
/// Steps [1] granted to every problem, beside `dual_steps_each`: a bound of the loop, far above what is measured.
inline constexpr int dual_steps = 100;
/// Steps for each half-space [1]. Measured: less than one.
inline constexpr int dual_steps_each = 20;

// Primal-dual active sets (primal_dual_active_set.cpp).

/// Changes [1] of the active set before others are tried. Measured: of 16 piles that begin from 30 sweeps 9 need up to
/// eight, 6 up to 13, and one does not settle in 60.
inline constexpr int most_set_changes = 24;
/// Part [1] of a tolerance that refinements of multipliers may leave: then the test of the other slacks decides.
inline constexpr double refined_enough = 1.0 / 8;
/// Rounds [1] of refinement by sparse products: each leaves `small_epsilon` / sigma^2 of what it mends, sigma the
/// singular values of the normals: 8 reach 1e-16 where sigma^2 is above 1e-4.
inline constexpr int sparse_refinements = 8;

// Sparse factors (primal_dual_active_set.cpp, active_factor.hpp, equalise.cpp).

/// Slacks [tolerances] that solve a problem with sparse factors: rounding of the sums over a body's contacts comes on
/// top of that of multipliers. Measured: 5.7 left at most (of an earlier sparse solver; not since).
inline constexpr double sparse_tolerances = 100;
/// Epsilon [1, against squares of singular values of at most about 10] of sparse products: below the squares of
/// singular values, for a tower of a thousand spheres 1.2e-6 (1 - cos of pi/2000). Multipliers carry the rounding of
/// slacks over epsilon, 1e-10 of the sizes that occur.
inline constexpr double small_epsilon = 1e-6;

// Shortest change (shortest_change.cpp).

/// Gradient squared [1, part of the square of what is wanted] that ends the search: u^2, its rounding.
inline constexpr double searched_enough = unit_roundoff * unit_roundoff;
/// Residual squared [1, part of the square of what is wanted] above which what is left is no rounding: 8 u of it.
inline constexpr double unmended = 64 * searched_enough;
/// Part [1] of a change that is as good as none: no more may go with multipliers that change nothing. No derivation is
/// known.
inline constexpr double negligible_change = 1e-10;
/// Steps [1] granted to every search, beside `search_steps_each`: a bound of the loop.
inline constexpr std::size_t search_steps = 20;
/// Steps for each unknown and each normal [1]: without rounding one would do (Hestenes and Stiefel).
inline constexpr std::size_t search_steps_each = 2;

}  // namespace carom
