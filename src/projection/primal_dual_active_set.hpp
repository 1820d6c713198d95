/// \file
/// The point of a polyhedron that is nearest to a given one, when it is nearly known which half-spaces bound it.
#pragma once

#include "projection/half_space.hpp"

namespace carom {

/// A guess of the active half-spaces is mended: their multipliers are found, half-spaces with negative ones leave,
/// violated half-spaces join, until neither happens. Hintermueller, Ito and Kunisch, The primal-dual active set
/// strategy as a semismooth Newton method, SIAM Journal on Optimization 13 (2003),
/// https://doi.org/10.1137/S1052623401383558. With sparse factors, for thousands: slacks are satisfied to 100
/// tolerances. It need not end, nor do with half-spaces that contradict each other: then, or after a few rounds, the
/// result is not complete, and another solver is due.
/// \param guess by half-space: those that are active have a multiplier > 0
Projection primal_dual_active_set(const ProjectionProblem& problem, std::span<const double> guess);

}  // namespace carom
