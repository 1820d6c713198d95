/// \file
/// Shock propagation: from the ground up, level by level, what lies lower counts as infinitely heavy.
///
/// Guendelman, Bridson and Fedkiw, Nonconvex rigid bodies with stacking, ACM Transactions on Graphics 22 (2003),
/// https://doi.org/10.1145/882262.882358, section 7. Ours: a body's level is its distance from immovable contacts in
/// the contact graph (the paper's comes from motion under gravity), bodies without any way to them are one level, and
/// each level runs the pair law in the order of its contacts until nothing closes.
///
/// Guarantee: impulses push, and where it ends nothing closes. What a body gives to a lower one goes into the ground:
/// neither momentum nor energy is kept (a lower body that moves up lifts everything above it with its speed). It need
/// not end within a level; after 10000 + 100 m impulses the response is the inelastic one.
#pragma once

#include "impact/operators.hpp"

namespace carom {

/// Rounds: impulses. Those of a contact between levels act on the upper body alone.
NormalImpact shock(const Cluster& cluster);

/// By body: 1 where it touches something immovable, else one more than the lowest neighbour; 1 for bodies that no
/// contacts join to anything immovable.
std::vector<int> shock_levels(const Cluster& cluster);

}  // namespace carom
