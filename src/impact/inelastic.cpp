#include "contact/contact_problem.hpp"
#include "impact/exact_steps.hpp"
#include "impact/operators.hpp"
#include "impact/tolerances.hpp"

#include "projection/project.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

Projection nearest(const ProjectionProblem& problem)
{
    Projection out = project(problem);
    if (out.steps == 0 || problem.half_spaces.size() > most_exact || !is_stiff(problem)) return out;
    const double closing = closing_in_projections * problem.tolerance;
    ExactSteps steps(problem, closing);
    Step step{{}, {}, 1};
    for (std::size_t i = 0; i < out.multipliers.size(); ++i)
        if (out.multipliers[i] > 0) step.contacts.push_back(static_cast<int>(i));
    steps.take_once(step);
    std::vector<double> multipliers = steps.impulses();
    for (std::size_t i = 0; i < multipliers.size(); ++i)
        if (!(multipliers[i] >= 0) || !std::isfinite(multipliers[i]) || steps.closes(static_cast<int>(i))) return out;
    out.multipliers = std::move(multipliers);
    out.point = steps.vectors();
    return out;
}

NormalImpact inelastic(const ContactProblem& cluster)
{
    const ProjectionProblem problem = projection_problem(cluster);
    Projection solved = nearest(problem);
    NormalImpact out;
    out.rounds = 1;
    out.impulses = std::move(solved.multipliers);
    if (is_stiff(problem)) out.velocities = std::move(solved.point);
    return out;
}

NormalImpact without_end(const ContactProblem& cluster, NormalImpact rounds)
{
    NormalImpact stuck = inelastic(cluster);
    rounds.impulses = std::move(stuck.impulses);
    rounds.velocities = std::move(stuck.velocities);
    rounds.capped = true;
    return rounds;
}

}  // namespace carom
