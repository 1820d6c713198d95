/// \file
/// The pair law again and again in the order of the contacts: impulses one after the other, as in Hahn, Realistic
/// animation of rigid bodies, SIGGRAPH 1988, https://doi.org/10.1145/54852.378530, and in Moore and Wilhelms, Collision
/// detection and response for computer animation, SIGGRAPH 1988, https://doi.org/10.1145/54852.378528.
///
/// Guarantee: impulses push, momentum is kept, energy is never gained, and where it ends nothing closes. The order of
/// the contacts decides the outcome, with e = 0 too. Impulses that accumulate (inelastic collapse) have a limit, which
/// is the outcome; of two contacts that close in turn for ever it is that of e = 0. Elastic impulses need not end (a
/// pinched sphere): then, and after 10000 + 100 m others, the response is the inelastic one.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
#include "impact/exact_steps.hpp"
#include "impact/pair_sweeps.hpp"

#include <numeric>

namespace carom {

NormalImpact sequential(const ContactProblem& cluster)
{
    const std::size_t count = cluster.contacts.size();
    std::vector<int> contacts(count);
    std::iota(contacts.begin(), contacts.end(), 0);
    std::vector<double> inverse_masses;
    for (const ContactBody& body : cluster.bodies) inverse_masses.push_back(body.inverse_mass);

    PairSweeps sweeps{velocities_before(cluster), std::vector<double>(count, 0.0), 0};
    NormalImpact out;
    out.capped = !sweep_pairs(cluster, contacts, inverse_masses, sweeps);
    out.rounds = sweeps.count;
    if (out.capped) return without_end(cluster, std::move(out));
    out.impulses = std::move(sweeps.impulses);
    if (is_stiff(projection_problem(cluster))) out.velocities = std::move(sweeps.velocities);
    return out;
}

}  // namespace carom
