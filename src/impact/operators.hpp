/// \file
/// The impact operators, each in a file of its name. They answer with impulses along the normals; tangential parts come
/// after them, see resolve_cluster.
#pragma once

#include "impact/cluster.hpp"

#include <carom/response.hpp>

#include <vector>

namespace carom {

struct NormalImpact {
    std::vector<double> impulses;  ///< by contact, along its normal on a, against it on b [mass length/time]
    int rounds = 0;
    bool jammed = false;  ///< `reflections`: a jammed set was found and projected
    bool capped = false;  ///< the bound on rounds was met: the impulses are the inelastic ones
    /// `shock`: velocities after, as impulses on lower bodies went into the ground. Empty: those that the impulses
    /// give.
    std::vector<Vec3> velocities;
};

/// All contacts inelastic: the velocities nearest to those before, in the metric of kinetic energy, that close nothing.
/// Multipliers are the impulses; they need not be unique, the velocities are.
NormalImpact inelastic(const Cluster& cluster);

}  // namespace carom
