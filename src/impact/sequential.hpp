/// \file
/// The pair law again and again in the order of the contacts: impulses one after the other, as in Hahn, Realistic
/// animation of rigid bodies, SIGGRAPH 1988, https://doi.org/10.1145/54852.378530, and in Moore and Wilhelms, Collision
/// detection and response for computer animation, SIGGRAPH 1988, https://doi.org/10.1145/54852.378528.
///
/// Guarantee: impulses push, momentum is kept, energy is never gained, and where it ends nothing closes. The order of
/// the contacts decides the outcome. It need not end (a pinched sphere; inelastic collapse): after 10000 + 100 m
/// impulses, or when all speeds have vanished against those at the start, the response is the inelastic one.
#pragma once

#include "impact/operators.hpp"

namespace carom {

/// Rounds: impulses.
NormalImpact sequential(const Cluster& cluster);

}  // namespace carom
