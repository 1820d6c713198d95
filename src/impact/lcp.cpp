/// \file
/// Several contacts at once as one linear complementarity problem in the impulses.
///
/// Newton: Moreau, Unilateral contact and dry friction in finite freedom dynamics, 1988,
/// https://doi.org/10.1007/978-3-7091-2624-0_1: 0 <= lambda _|_ c+ + e c- >= 0. Poisson: Glocker and Pfeiffer, Multiple
/// impacts with friction in rigid multibody systems, Nonlinear Dynamics 7 (1995), https://doi.org/10.1007/BF00121109:
/// compression 0 <= lambda _|_ c >= 0, then each contact gives back e lambda at least. Solved exactly (the matrix is
/// A^T A, so that this is a projection), or by projected Gauss-Seidel.
///
/// Guarantee: impulses push and momentum is kept; with one e everywhere energy is never gained (Newton, Poisson).
/// Contacts do not break away one after the other: of a cradle all balls leave. Newton with mixed e may gain energy or
/// have no solution; then, as where sweeps do not suffice, the last inelastic impact of resolve_cluster sees that
/// nothing closes. Poisson's outcome depends on the multipliers, which redundant contacts leave open.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"

#include "projection/gauss_seidel.hpp"
#include "projection/project.hpp"

namespace carom {

namespace {

Projection solve(const ProjectionProblem& problem, const LcpOptions& options)
{
    if (options.solver == LcpSolver::exact) return project(problem);
    return gauss_seidel(problem, options.sweeps, std::vector<double>(problem.half_spaces.size(), 0.0));
}

NormalImpact newton(const ContactProblem& cluster, const LcpOptions& options)
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

NormalImpact poisson(const ContactProblem& cluster, const LcpOptions& options)
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

NormalImpact lcp(const ContactProblem& cluster, const LcpOptions& options)
{
    return options.law == LcpLaw::newton ? newton(cluster, options) : poisson(cluster, options);
}

}  // namespace carom
