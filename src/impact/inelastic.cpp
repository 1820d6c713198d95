#include "impact/cluster_problem.hpp"
#include "impact/operators.hpp"

#include "math/project.hpp"

namespace carom {

NormalImpact inelastic(const Cluster& cluster)
{
    NormalImpact out;
    out.impulses = project(projection_problem(cluster)).multipliers;
    out.rounds = 1;
    return out;
}

}  // namespace carom
