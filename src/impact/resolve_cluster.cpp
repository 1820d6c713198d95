#include "impact/resolve_cluster.hpp"

#include "contact/contact_problem.hpp"
#include "impact/jam.hpp"
#include "impact/operators.hpp"
#include "impact/pair_law.hpp"
#include "impact/tangential.hpp"
#include "impact/tolerances.hpp"

#include "core/expect.hpp"

#include <algorithm>
#include <numeric>

namespace carom {

namespace {

ClusterImpact single_contact(const ContactProblem& cluster)
{
    const Contact& contact = cluster.contacts.front();
    const auto side = [&](std::optional<int> body) {
        if (!body) return ImpactSide{};
        const ContactBody& at = cluster.bodies[static_cast<std::size_t>(*body)];
        return ImpactSide{at.velocity, at.inverse_mass};
    };
    const PairImpact pair =
        resolve_pair(side(contact.a), side(contact.b), contact.normal, {contact.restitution, contact.tangential, 1});
    ClusterImpact out;
    for (const ContactBody& body : cluster.bodies) out.velocities.push_back(body.velocity);
    out.velocities[static_cast<std::size_t>(contact.a)] = pair.velocity_a;
    if (contact.b) out.velocities[static_cast<std::size_t>(*contact.b)] = pair.velocity_b;
    out.impulses = {pair.impulse};
    out.rounds = 1;
    return out;
}

NormalImpact normal_impact(const ContactProblem& cluster, const ImpactOptions& options)
{
    switch (options.impact_operator) {
        case ImpactOperator::sequential:
            return sequential(cluster);
        case ImpactOperator::lcp:
            return lcp(cluster, options.lcp);
        case ImpactOperator::shock:
            return shock(cluster);
        case ImpactOperator::jacobi:
            return jacobi(cluster);
        case ImpactOperator::reflections:
            break;
    }
    return reflections(cluster);
}

void add_tangential(const ContactProblem& cluster, const std::vector<double>& normal_impulses, ClusterImpact& out)
{
    if (std::all_of(cluster.contacts.begin(), cluster.contacts.end(),
                    [](const Contact& contact) { return contact.tangential == 1; }))
        return;
    const std::vector<Vec3> sideways = tangential_impulses(cluster, out.velocities, normal_impulses);
    for (std::size_t i = 0; i < sideways.size(); ++i) out.impulses[i] += sideways[i];
    out.velocities = velocities_after(cluster, out.velocities, sideways);
}

/// A last inelastic impact, if some contact still closes.
void open_all(const ContactProblem& cluster, ClusterImpact& out)
{
    ProjectionProblem rest = projection_problem(cluster);
    rest.start = out.velocities;
    rest.tolerance = std::max(rest.tolerance, projection_tolerance * largest_speed(rest.start));
    Projection last = nearest(rest);
    if (last.steps == 0) return;
    for (std::size_t i = 0; i < last.multipliers.size(); ++i)
        out.impulses[i] += last.multipliers[i] * cluster.contacts[i].normal;
    out.velocities = std::move(last.point);
}

/// Whether the operator promises that energy is not gained, whatever the restitutions.
[[maybe_unused]] bool keeps_energy(const ImpactOptions& options)
{
    return options.impact_operator == ImpactOperator::reflections ||
           options.impact_operator == ImpactOperator::sequential;
}

/// Whether anything is promised for this ratio of masses.
[[maybe_unused]] bool is_well_scaled(const ContactProblem& cluster)
{
    double least = cluster.bodies.front().inverse_mass, largest = least;
    for (const ContactBody& body : cluster.bodies) {
        least = std::min(least, body.inverse_mass);
        largest = std::max(largest, body.inverse_mass);
    }
    return largest <= largest_mass_ratio * least;
}

/// Whether nothing closes faster than `feasible`, or than `feasible_if_jammed` in jammed sets. \param speed the largest
[[maybe_unused]] bool nothing_closes_after(const ContactProblem& cluster, const std::vector<Vec3>& velocities,
                                           double speed)
{
    if (nothing_closes(cluster, velocities, feasible * speed)) return true;
    std::vector<int> all(cluster.contacts.size());
    std::iota(all.begin(), all.end(), 0);
    std::vector<char> jammed(all.size(), 0);
    while (mark_jammed(projection_problem(cluster), all, jammed)) {
    }
    return std::all_of(all.begin(), all.end(), [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        return closing_rate(cluster.contacts[k], velocities) >= -(jammed[k] ? feasible_if_jammed : feasible) * speed;
    });
}

}  // namespace

ClusterImpact resolve_cluster(const ContactProblem& cluster, const ImpactOptions& options)
{
    CAROM_EXPECT(!cluster.contacts.empty());
    const std::vector<Vec3> before = velocities_before(cluster);
    if (cluster.contacts.size() == 1 && closing_rate(cluster.contacts.front(), before) <= 0)
        return single_contact(cluster);

    const NormalImpact normal = normal_impact(cluster, options);
    ClusterImpact out;
    out.rounds = normal.rounds;
    out.jammed = normal.jammed;
    out.capped = normal.capped;
    for (std::size_t i = 0; i < normal.impulses.size(); ++i)
        out.impulses.push_back(normal.impulses[i] * cluster.contacts[i].normal);
    out.velocities = normal.velocities ? *normal.velocities : velocities_after(cluster, before, out.impulses);
    add_tangential(cluster, normal.impulses, out);
    open_all(cluster, out);

    CAROM_EXPECT(
        !is_well_scaled(cluster) ||
        nothing_closes_after(cluster, out.velocities, std::max(largest_speed(before), largest_speed(out.velocities))));
    CAROM_EXPECT(!is_well_scaled(cluster) || !keeps_energy(options) ||
                 kinetic_energy(cluster, out.velocities) <= (1 + energy_rounding) * kinetic_energy(cluster, before));
    return out;
}

}  // namespace carom
