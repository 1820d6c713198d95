#include "impact/tangential.hpp"

#include "contact/contact_problem.hpp"

#include <algorithm>

namespace carom {

namespace {

double reduced_mass(const ContactProblem& cluster, const Contact& contact)
{
    const double a = cluster.bodies[static_cast<std::size_t>(contact.a)].inverse_mass;
    if (!contact.b) return 1 / a;
    return 1 / (a + cluster.bodies[static_cast<std::size_t>(*contact.b)].inverse_mass);
}

}  // namespace

std::vector<Vec3> tangential_impulses(const ContactProblem& cluster, const std::vector<Vec3>& velocities,
                                      std::span<const double> impulses)
{
    const std::size_t count = cluster.contacts.size();
    const double least_speed = closing_tolerance * largest_speed(velocities);
    std::vector<char> hit(count, 0);
    std::vector<int> hits(cluster.bodies.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
        const Contact& contact = cluster.contacts[i];
        if (impulses[i] <= reduced_mass(cluster, contact) * least_speed) continue;
        hit[i] = 1;
        ++hits[static_cast<std::size_t>(contact.a)];
        if (contact.b) ++hits[static_cast<std::size_t>(*contact.b)];
    }
    std::vector<Vec3> out(count, Vec3::Zero());
    for (std::size_t i = 0; i < count; ++i) {
        const Contact& contact = cluster.contacts[i];
        if (!hit[i] || contact.tangential == 1) continue;
        Vec3 relative = velocities[static_cast<std::size_t>(contact.a)];
        int shared = hits[static_cast<std::size_t>(contact.a)];
        if (contact.b) {
            relative -= velocities[static_cast<std::size_t>(*contact.b)];
            shared = std::max(shared, hits[static_cast<std::size_t>(*contact.b)]);
        }
        const Vec3 along = relative - relative.dot(contact.normal) * contact.normal;
        out[i] = -((1 - contact.tangential) * reduced_mass(cluster, contact) / shared) * along;
    }
    return out;
}

}  // namespace carom
