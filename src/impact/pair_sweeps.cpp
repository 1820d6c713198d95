#include "impact/pair_sweeps.hpp"

#include "contact/contact_problem.hpp"
#include "impact/tolerances.hpp"

#include <algorithm>

namespace carom {

namespace {

double speed_of(const Contact& contact, const std::vector<Vec3>& velocities)
{
    const double a = velocities[static_cast<std::size_t>(contact.a)].cwiseAbs().maxCoeff();
    if (!contact.b) return a;
    return std::max(a, velocities[static_cast<std::size_t>(*contact.b)].cwiseAbs().maxCoeff());
}

}  // namespace

bool sweep_pairs(const ContactProblem& cluster, std::span<const int> contacts, std::span<const double> inverse_masses,
                 int most, PairSweeps& state)
{
    const double least = collapsed * largest_speed(state.velocities);
    for (bool closes = true; closes;) {
        closes = false;
        for (const int index : contacts) {
            const auto i = static_cast<std::size_t>(index);
            const Contact& contact = cluster.contacts[i];
            const double rate = closing_rate(contact, state.velocities);
            // Against the speeds of now: in a collapse all of them shrink together.
            if (rate >= -closing_tolerance * speed_of(contact, state.velocities)) continue;
            if (state.count >= most || rate > -least) return false;
            closes = true;
            const auto a = static_cast<std::size_t>(contact.a);
            const double w_a = inverse_masses[a];
            const double w_b = contact.b ? inverse_masses[static_cast<std::size_t>(*contact.b)] : 0;
            const double impulse = -(1 + contact.restitution) * rate / (w_a + w_b);
            state.velocities[a] += (w_a * impulse) * contact.normal;
            if (contact.b) state.velocities[static_cast<std::size_t>(*contact.b)] -= (w_b * impulse) * contact.normal;
            state.impulses[i] += impulse;
            ++state.count;
        }
    }
    return true;
}

}  // namespace carom
