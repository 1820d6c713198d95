#include "impact/shock.hpp"

#include "impact/cluster_problem.hpp"
#include "impact/pair_sweeps.hpp"

#include <algorithm>

namespace carom {

std::vector<int> shock_levels(const Cluster& cluster)
{
    std::vector<std::vector<int>> neighbours(cluster.bodies.size());
    std::vector<int> level(cluster.bodies.size(), 0), front;
    for (const ClusterContact& contact : cluster.contacts) {
        int& mine = level[static_cast<std::size_t>(contact.a)];
        if (contact.b == immovable) {
            if (mine == 0) front.push_back(contact.a);
            mine = 1;
        } else {
            neighbours[static_cast<std::size_t>(contact.a)].push_back(contact.b);
            neighbours[static_cast<std::size_t>(contact.b)].push_back(contact.a);
        }
    }
    for (std::size_t next = 0; next < front.size(); ++next) {
        const auto body = static_cast<std::size_t>(front[next]);
        for (const int other : neighbours[body]) {
            if (level[static_cast<std::size_t>(other)] != 0) continue;
            level[static_cast<std::size_t>(other)] = level[body] + 1;
            front.push_back(other);
        }
    }
    std::replace(level.begin(), level.end(), 0, 1);
    return level;
}

NormalImpact shock(const Cluster& cluster)
{
    const std::vector<int> level = shock_levels(cluster);
    const std::size_t count = cluster.contacts.size();
    std::vector<std::vector<int>> contacts(static_cast<std::size_t>(*std::max_element(level.begin(), level.end())) + 1);
    for (std::size_t i = 0; i < count; ++i) {
        int upper = level[static_cast<std::size_t>(cluster.contacts[i].a)];
        if (cluster.contacts[i].b != immovable)
            upper = std::max(upper, level[static_cast<std::size_t>(cluster.contacts[i].b)]);
        contacts[static_cast<std::size_t>(upper)].push_back(static_cast<int>(i));
    }
    std::vector<double> inverse_masses;
    for (const ClusterBody& body : cluster.bodies) inverse_masses.push_back(body.inverse_mass);

    PairSweeps sweeps{velocities_before(cluster), std::vector<double>(count, 0.0), 0};
    NormalImpact out;
    for (std::size_t now = 1; now < contacts.size() && !out.capped; ++now) {
        out.capped = !sweep_pairs(cluster, contacts[now], inverse_masses, most_impulses(count), sweeps);
        for (std::size_t k = 0; k < level.size(); ++k)
            if (level[k] == static_cast<int>(now)) inverse_masses[k] = 0;
    }
    out.rounds = sweeps.count;
    out.impulses = out.capped ? inelastic(cluster).impulses : std::move(sweeps.impulses);
    if (!out.capped) out.velocities = std::move(sweeps.velocities);
    return out;
}

}  // namespace carom
