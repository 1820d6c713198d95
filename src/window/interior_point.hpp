/// \file
/// The point of a polyhedron that is nearest to a given one, for thousands of half-spaces of which nobody knows which
/// bound it: in some 15 factorisations whatever their number.
#pragma once

#include "projection/half_space.hpp"

namespace carom {

/// Predictor and corrector of Mehrotra, On the implementation of a primal-dual interior point method, SIAM Journal on
/// Optimization 2 (1992), https://doi.org/10.1137/0802028, for the convex program |y|^2 / 2 in the metric's
/// coordinates: each step is a sparse factor of the unit matrix plus products of normals. A result that is not complete
/// is still start + pushes.
/// \param scale > 0 [as the vectors]: the size of the changes that are to be expected
/// \returns multipliers, 0 of half-spaces that do not bound the point; `steps` are factorisations. Half-spaces that
/// touch the point and bear nothing may keep some 1e-6 of the scale.
Projection interior_point(const ProjectionProblem& problem, double scale);

}  // namespace carom
