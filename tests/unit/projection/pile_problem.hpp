/// \file
/// Projection problems of piles: the contacts of spheres on a lattice, velocities that close many of them.
#pragma once

#include "contact/contact_problem.hpp"
#include "projection/half_space.hpp"

#include "support/clusters.hpp"

namespace carom::test {

/// \param falling all at one velocity; otherwise in random directions
inline ProjectionProblem pile_problem(int side, int layers, bool falling)
{
    ContactProblem cluster = pile(side, layers);
    carom::Random random(9);
    for (ContactBody& body : cluster.bodies) body.velocity = falling ? Vec3(0, 0, -1) : random.direction();
    return projection_problem(cluster);
}

inline double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b)
{
    double out = 0;
    for (std::size_t k = 0; k < a.size(); ++k) out = std::max(out, (a[k] - b[k]).cwiseAbs().maxCoeff());
    return out;
}

}  // namespace carom::test
