#include "impact/resolve_cluster.hpp"

#include "impact/cluster_problem.hpp"
#include "impact/pair_law.hpp"
#include "impact/reflections.hpp"
#include "impact/tangential.hpp"

#include "core/expect.hpp"
#include "math/project.hpp"

#include <algorithm>

namespace carom {

namespace {

/// Of the largest speed before: no contact closes faster after.
[[maybe_unused]] constexpr double feasible = 1e-9;
/// Of the energy before: what rounding may add.
[[maybe_unused]] constexpr double energy_rounding = 1e-9;

ClusterImpact single_contact(const Cluster& cluster)
{
    const ClusterContact& contact = cluster.contacts.front();
    const auto side = [&](int body) {
        if (body == immovable) return ImpactSide{};
        const ClusterBody& at = cluster.bodies[static_cast<std::size_t>(body)];
        return ImpactSide{at.velocity, at.inverse_mass};
    };
    const PairImpact pair =
        resolve_pair(side(contact.a), side(contact.b), contact.normal, {contact.restitution, contact.tangential, 1});
    ClusterImpact out;
    for (const ClusterBody& body : cluster.bodies) out.velocities.push_back(body.velocity);
    out.velocities[static_cast<std::size_t>(contact.a)] = pair.velocity_a;
    if (contact.b != immovable) out.velocities[static_cast<std::size_t>(contact.b)] = pair.velocity_b;
    out.impulses = {pair.impulse};
    out.rounds = 1;
    return out;
}

NormalImpact normal_impact(const Cluster& cluster, const ImpactOptions&)
{
    if (std::all_of(cluster.contacts.begin(), cluster.contacts.end(),
                    [](const ClusterContact& contact) { return contact.restitution == 0; }))
        return inelastic(cluster);
    return reflections(cluster);
}

/// The velocities that the impulses give, after a last inelastic impact if some contact still closes.
void finish(const Cluster& cluster, ClusterImpact& out)
{
    out.velocities = velocities_after(cluster, out.impulses);
    ProjectionProblem rest = projection_problem(cluster);
    rest.start = out.velocities;
    rest.tolerance = std::max(rest.tolerance, projection_tolerance * largest_speed(rest.start));
    const Projection last = project(rest);
    bool moved = false;
    for (std::size_t i = 0; i < last.multipliers.size(); ++i) {
        if (last.multipliers[i] == 0) continue;
        out.impulses[i] += last.multipliers[i] * cluster.contacts[i].normal;
        moved = true;
    }
    if (moved) out.velocities = last.point;
}

}  // namespace

ClusterImpact resolve_cluster(const Cluster& cluster, const ImpactOptions& options)
{
    CAROM_EXPECT(!cluster.contacts.empty());
    const std::vector<Vec3> before = velocities_after(cluster, {});
    if (cluster.contacts.size() == 1 && closing_rate(cluster.contacts.front(), before) <= 0)
        return single_contact(cluster);

    const NormalImpact normal = normal_impact(cluster, options);
    ClusterImpact out;
    out.rounds = normal.rounds;
    out.jammed = normal.jammed;
    out.capped = normal.capped;
    for (std::size_t i = 0; i < normal.impulses.size(); ++i)
        out.impulses.push_back(normal.impulses[i] * cluster.contacts[i].normal);
    if (std::any_of(cluster.contacts.begin(), cluster.contacts.end(),
                    [](const ClusterContact& contact) { return contact.tangential != 1; })) {
        const std::vector<Vec3> sideways =
            tangential_impulses(cluster, velocities_after(cluster, out.impulses), normal.impulses);
        for (std::size_t i = 0; i < sideways.size(); ++i) out.impulses[i] += sideways[i];
    }
    finish(cluster, out);

    CAROM_EXPECT(nothing_closes(cluster, out.velocities, feasible * largest_speed(before)));
    CAROM_EXPECT(kinetic_energy(cluster, out.velocities) <= (1 + energy_rounding) * kinetic_energy(cluster, before));
    return out;
}

}  // namespace carom
