/// \file
/// The pair law again and again in the order of the contacts: impulses one after the other, as in Hahn, Realistic
/// animation of rigid bodies, SIGGRAPH 1988, https://doi.org/10.1145/54852.378530, and in Moore and Wilhelms, Collision
/// detection and response for computer animation, SIGGRAPH 1988, https://doi.org/10.1145/54852.378528.
///
/// Guarantee: impulses push, momentum is kept, energy is never gained, and where it ends nothing closes. The order of
/// the contacts decides the outcome. It need not end (a pinched sphere; inelastic collapse): after 10000 + 100 m
/// impulses, or when all speeds have vanished against those at the start, the response is the inelastic one.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
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
    const bool ended = sweep_pairs(cluster, contacts, inverse_masses, most_impulses(count), sweeps);
    NormalImpact out;
    out.impulses = ended ? std::move(sweeps.impulses) : inelastic(cluster).impulses;
    out.rounds = sweeps.count;
    out.capped = !ended;
    return out;
}

}  // namespace carom
