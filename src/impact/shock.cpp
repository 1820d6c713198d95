/// \file
/// Shock propagation: from the ground up, level by level, what lies lower counts as infinitely heavy.
///
/// Guendelman, Bridson and Fedkiw, Nonconvex rigid bodies with stacking, ACM Transactions on Graphics 22 (2003),
/// https://doi.org/10.1145/882262.882358, section 7. This project's: a body's level is its distance from immovable
/// contacts in the contact graph (the paper's comes from motion under gravity), bodies without any way to them are one
/// level, and each level runs the pair law in the order of its contacts until nothing closes.
///
/// Guarantee: impulses push, and where it ends nothing closes. Momentum given to a lower body goes into the ground:
/// neither momentum nor energy is kept (a lower body that moves up lifts everything above it with its speed). Each
/// level ends as `sequential` does, or not.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
#include "impact/pair_sweeps.hpp"

#include <algorithm>

namespace carom {

std::vector<int> shock_levels(const ContactProblem& cluster)
{
    std::vector<std::vector<int>> neighbours(cluster.bodies.size());
    std::vector<int> level(cluster.bodies.size(), 0), front;
    for (const Contact& contact : cluster.contacts) {
        int& mine = level[static_cast<std::size_t>(contact.a)];
        if (!contact.b) {
            if (mine == 0) front.push_back(contact.a);
            mine = 1;
        } else {
            neighbours[static_cast<std::size_t>(contact.a)].push_back(*contact.b);
            neighbours[static_cast<std::size_t>(*contact.b)].push_back(contact.a);
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

NormalImpact shock(const ContactProblem& cluster)
{
    const std::vector<int> level = shock_levels(cluster);
    const std::size_t count = cluster.contacts.size();
    std::vector<std::vector<int>> contacts(static_cast<std::size_t>(*std::max_element(level.begin(), level.end())) + 1);
    for (std::size_t i = 0; i < count; ++i) {
        int upper = level[static_cast<std::size_t>(cluster.contacts[i].a)];
        if (cluster.contacts[i].b) upper = std::max(upper, level[static_cast<std::size_t>(*cluster.contacts[i].b)]);
        contacts[static_cast<std::size_t>(upper)].push_back(static_cast<int>(i));
    }
    std::vector<double> inverse_masses;
    for (const ContactBody& body : cluster.bodies) inverse_masses.push_back(body.inverse_mass);

    PairSweeps sweeps{velocities_before(cluster), std::vector<double>(count, 0.0), 0};
    NormalImpact out;
    for (std::size_t now = 1; now < contacts.size() && !out.capped; ++now) {
        out.capped = !sweep_pairs(cluster, contacts[now], inverse_masses, sweeps);
        for (std::size_t k = 0; k < level.size(); ++k)
            if (level[k] == static_cast<int>(now)) inverse_masses[k] = 0;
    }
    out.rounds = sweeps.count;
    if (out.capped) return without_end(cluster, std::move(out));
    out.impulses = std::move(sweeps.impulses);
    out.velocities = std::move(sweeps.velocities);
    return out;
}

}  // namespace carom
