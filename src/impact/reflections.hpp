/// \file
/// Generalized reflections: several elastic contacts at once, every one of which may break away, symmetric scenes stay
/// symmetric, energy and momentum are kept.
///
/// Smith, Kaufman, Vouga, Tamstorf and Grinspun, Reflections on simultaneous impact, ACM Transactions on Graphics 31
/// (2012), https://doi.org/10.1145/2185520.2185602: rounds u <- 2 P_V(u) - u over the contacts V that close, P_V the
/// projection on the velocities that close none of V, in the metric of kinetic energy.
/// Ours, in the spirit of Vouga et al., All's well that ends well, ACM Transactions on Graphics 36 (2017),
/// https://doi.org/10.1145/3072959.3073689: the jam test, the bound on rounds and the blend of mixed restitution.
///
/// Guarantee: nothing closes faster than 1e-9 of the largest speed before; impulses push; momentum is kept; energy is
/// never gained. It ends: where unit normals a_i allow w, |w| = 1, with a_i.w >= delta > 0, each round raises w.u by
/// 2 delta eps at least while it is bounded by |u|; where they do not, that set is jammed: its bodies cannot move
/// apart, nor rebound from each other, and it stays closed. Rounds are bounded all the same, by 100 + 10 min(m, 100),
/// where all e = 1 by a million / m (a light body between two of M times its mass takes some 3 M^(1/2)); beyond, the
/// response is the inelastic one.
#pragma once

#include "impact/operators.hpp"

namespace carom {

struct ReflectionsOptions {
    bool jam_test = true;  ///< off, for comparison: jammed clusters then meet the bound on rounds
};

NormalImpact reflections(const Cluster& cluster, const ReflectionsOptions& options = {});

}  // namespace carom
