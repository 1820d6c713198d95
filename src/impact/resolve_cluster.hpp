/// \file
/// Impact of several contacts at once.
#pragma once

#include "contact/contact.hpp"

#include <carom/response.hpp>

namespace carom {

struct ClusterImpact {
    std::vector<Vec3> velocities;  ///< after, by body [length/time]
    std::vector<Vec3> impulses;    ///< by contact, on a; -impulse acts on b [mass length/time]
    int rounds = 0;                ///< of the operator
    bool jammed = false;           ///< `reflections`: a jammed set was found and projected
    /// The operator reached its bound, and what follows is as if all were inelastic (which always can be solved).
    bool capped = false;
};

/// \pre the cluster is connected and has a contact that closes
/// \post (for ratios of masses up to 1e12) no contact closes faster than 1e-9 of the largest speed before, in jammed
/// sets than 4e-8 (a wedge narrower than 2e-8 is none, see `feasible_if_jammed`); momentum of bodies away from
/// immovable ones is kept; energy is not gained; impulses push, apart from their tangential parts (for `reflections`;
/// what the other operators promise stands in their headers)
ClusterImpact resolve_cluster(const ContactProblem& cluster, const ImpactOptions& options);

}  // namespace carom
