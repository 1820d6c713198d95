/// \file
/// Several contacts at once as one linear complementarity problem in the impulses.
///
/// Newton: Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988,
/// https://doi.org/10.1007/978-3-7091-2624-0_1: 0 <= lambda _|_ c+ + e c- >= 0. Poisson: Glocker and Pfeiffer, Multiple
/// impacts with friction in rigid multibody systems, Nonlinear Dynamics 7 (1995), https://doi.org/10.1007/BF00121109:
/// compression 0 <= lambda _|_ c >= 0, then each contact gives back e lambda at least. Solved exactly (the matrix is
/// A^T A, so that this is a projection), or by projected Gauss-Seidel.
///
/// Guarantee: impulses push and momentum is kept; with one e everywhere energy is never gained (Newton, Poisson).
/// Contacts do not break away one after the other: of a cradle all balls leave. Newton with mixed e may gain energy or
/// have no solution; then, as where sweeps do not suffice, the last inelastic impact of resolve_cluster sees that
/// nothing closes. Poisson's outcome depends on the multipliers, which redundant contacts leave open.
#pragma once

#include "impact/operators.hpp"

namespace carom {

/// Rounds: steps of the solver.
NormalImpact lcp(const Cluster& cluster, const LcpOptions& options);

}  // namespace carom
