#include "contact/contact_problem.hpp"
#include "impact/operators.hpp"

#include "projection/project.hpp"

namespace carom {

NormalImpact inelastic(const ContactProblem& cluster)
{
    NormalImpact out;
    out.impulses = project(projection_problem(cluster)).multipliers;
    out.rounds = 1;
    return out;
}

}  // namespace carom
