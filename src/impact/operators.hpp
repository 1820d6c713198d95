/// \file
/// The impact operators, each in a file of its name, which says its law, source and guarantee. They answer with
/// impulses along the normals; tangential parts come after them, see resolve_cluster.
#pragma once

#include "contact/contact.hpp"
#include "projection/half_space.hpp"

#include <carom/response.hpp>

#include <optional>
#include <vector>

namespace carom {

struct NormalImpact {
    std::vector<double> impulses;  ///< by contact, along its normal on a, against it on b [mass length/time]
    int rounds = 0;                ///< `sequential`, `shock`: impulses; `lcp`: steps of the solver
    bool jammed = false;           ///< `reflections`: a jammed set was found and projected
    bool capped = false;           ///< the bound on rounds was met: the impulses are the inelastic ones
    /// Velocities after, where impulses do not give them: those of `shock` on lower bodies go into the ground, and of
    /// stiff clusters they cancel. Elsewhere those that the impulses give.
    std::optional<std::vector<Vec3>> velocities{};
};

/// The response with all contacts inelastic: the velocities nearest to those before, in the metric of kinetic energy,
/// that close nothing. Multipliers are the impulses; they need not be unique, the velocities are.
NormalImpact inelastic(const ContactProblem& cluster);
/// The same for an operator that met its bound, whose rounds these are.
NormalImpact without_end(const ContactProblem& cluster, NormalImpact rounds);
/// The projection that it is, in stiff problems to the rounding of velocities.
Projection nearest(const ProjectionProblem& problem);

struct ReflectionsOptions {
    bool jam_test = true;  ///< off, for comparison: jammed clusters then meet the bound on rounds
};
NormalImpact reflections(const ContactProblem& cluster, const ReflectionsOptions& options = {});

NormalImpact sequential(const ContactProblem& cluster);
NormalImpact lcp(const ContactProblem& cluster, const LcpOptions& options);
NormalImpact jacobi(const ContactProblem& cluster);

/// Shock propagation: impulses of a contact between levels act on the upper body alone.
NormalImpact shock(const ContactProblem& cluster);
/// The level of each body: 1 if it touches something immovable, else one more than its lowest neighbour; 1 for bodies
/// that no contacts join to anything immovable.
std::vector<int> shock_levels(const ContactProblem& cluster);

}  // namespace carom
