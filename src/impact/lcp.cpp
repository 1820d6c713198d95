#include "impact/lcp.hpp"

#include "impact/cluster_problem.hpp"

#include "math/gauss_seidel.hpp"
#include "math/project.hpp"

namespace carom {

namespace {

Projection solve(const ProjectionProblem& problem, const LcpOptions& options)
{
    if (options.solver == LcpSolver::exact) return project(problem);
    return gauss_seidel(problem, options.sweeps, std::vector<double>(problem.half_spaces.size(), 0.0));
}

NormalImpact newton(const Cluster& cluster, const LcpOptions& options)
{
    ProjectionProblem problem = projection_problem(cluster);
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
        HalfSpace& h = problem.half_spaces[i];
        h.offset = cluster.contacts[i].restitution * slack(h, problem.start);
    }
    Projection solved = solve(problem, options);
    NormalImpact out;
    out.rounds = solved.steps;
    out.capped = options.solver == LcpSolver::exact && !solved.complete;
    out.impulses = out.capped ? inelastic(cluster).impulses : std::move(solved.multipliers);
    return out;
}

NormalImpact poisson(const Cluster& cluster, const LcpOptions& options)
{
    ProjectionProblem problem = projection_problem(cluster);
    const Projection compression = solve(problem, options);
    problem.start = compression.point;
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i)
        push(problem.half_spaces[i], problem.w, cluster.contacts[i].restitution * compression.multipliers[i],
             problem.start);
    const Projection expansion = solve(problem, options);
    NormalImpact out;
    out.rounds = compression.steps + expansion.steps;
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i)
        out.impulses.push_back((1 + cluster.contacts[i].restitution) * compression.multipliers[i] +
                               expansion.multipliers[i]);
    return out;
}

}  // namespace

NormalImpact lcp(const Cluster& cluster, const LcpOptions& options)
{
    return options.law == LcpLaw::newton ? newton(cluster, options) : poisson(cluster, options);
}

}  // namespace carom
