#include "contact/contact_problem.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

ProjectionProblem projection_problem(const ContactProblem& cluster)
{
    ProjectionProblem out;
    out.start.reserve(cluster.bodies.size());
    out.w.reserve(cluster.bodies.size());
    for (const ContactBody& body : cluster.bodies) {
        out.start.push_back(body.velocity);
        out.w.push_back(body.inverse_mass);
    }
    out.half_spaces.reserve(cluster.contacts.size());
    for (const Contact& contact : cluster.contacts)
        out.half_spaces.push_back({contact.a, contact.b, contact.normal, 0});
    out.tolerance = projection_tolerance * largest_speed(out.start);
    return out;
}

double largest_speed(std::span<const Vec3> velocities)
{
    double largest = 0;
    for (const Vec3& v : velocities) largest = std::max(largest, v.cwiseAbs().maxCoeff());
    return largest;
}

double kinetic_energy(const ContactProblem& cluster, std::span<const Vec3> velocities)
{
    double sum = 0;
    for (std::size_t k = 0; k < velocities.size(); ++k)
        sum += velocities[k].squaredNorm() / cluster.bodies[k].inverse_mass / 2;
    return sum;
}

std::vector<Vec3> velocities_before(const ContactProblem& cluster)
{
    std::vector<Vec3> out;
    out.reserve(cluster.bodies.size());
    for (const ContactBody& body : cluster.bodies) out.push_back(body.velocity);
    return out;
}

std::vector<Vec3> velocities_after(const ContactProblem& cluster, std::vector<Vec3> velocities,
                                   std::span<const Vec3> impulses)
{
    std::vector<Vec3> out = std::move(velocities);
    for (std::size_t i = 0; i < impulses.size(); ++i) {
        const Contact& contact = cluster.contacts[i];
        const auto a = static_cast<std::size_t>(contact.a);
        out[a] += cluster.bodies[a].inverse_mass * impulses[i];
        if (!contact.b) continue;
        const auto b = static_cast<std::size_t>(*contact.b);
        out[b] -= cluster.bodies[b].inverse_mass * impulses[i];
    }
    return out;
}

bool nothing_closes(const ContactProblem& cluster, std::span<const Vec3> velocities, double tolerance)
{
    const std::vector<Vec3> after(velocities.begin(), velocities.end());
    return std::all_of(cluster.contacts.begin(), cluster.contacts.end(),
                       [&](const Contact& contact) { return closing_rate(contact, after) >= -tolerance; });
}

}  // namespace carom
