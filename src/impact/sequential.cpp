#include "impact/sequential.hpp"

#include "impact/cluster_problem.hpp"
#include "impact/pair_sweeps.hpp"

#include <numeric>

namespace carom {

NormalImpact sequential(const Cluster& cluster)
{
    const std::size_t count = cluster.contacts.size();
    std::vector<int> contacts(count);
    std::iota(contacts.begin(), contacts.end(), 0);
    std::vector<double> inverse_masses;
    for (const ClusterBody& body : cluster.bodies) inverse_masses.push_back(body.inverse_mass);

    PairSweeps sweeps{velocities_before(cluster), std::vector<double>(count, 0.0), 0};
    const bool ended = sweep_pairs(cluster, contacts, inverse_masses, most_impulses(count), sweeps);
    NormalImpact out;
    out.impulses = ended ? std::move(sweeps.impulses) : inelastic(cluster).impulses;
    out.rounds = sweeps.count;
    out.capped = !ended;
    return out;
}

}  // namespace carom
