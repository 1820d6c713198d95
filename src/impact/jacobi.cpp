/// \file
/// The pair law of all contacts at once, again and again. For teaching: impulses that should share a body's motion add
/// up instead, so that energy may be gained.
///
/// Guarantee: impulses push, momentum is kept, symmetric scenes stay symmetric, and where it ends nothing closes.
/// Energy is not kept. After 100 + 10 m rounds, or with a million times the energy, the response is the inelastic one.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
#include "impact/tolerances.hpp"

namespace carom {

NormalImpact jacobi(const ContactProblem& cluster)
{
    ProjectionProblem at = projection_problem(cluster);
    const double eps = closing_tolerance * largest_speed(at.start);
    const double energy = kinetic_energy(cluster, at.start);
    const int most = usual_rounds + usual_rounds_each * static_cast<int>(cluster.contacts.size());
    NormalImpact out;
    out.impulses.assign(cluster.contacts.size(), 0);
    for (; out.rounds <= most && kinetic_energy(cluster, at.start) <= too_much_energy * energy; ++out.rounds) {
        const std::vector<Vec3> before = at.start;
        bool closes = false;
        for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
            const HalfSpace& h = at.half_spaces[i];
            const double rate = slack(h, before);
            if (rate >= -eps) continue;
            closes = true;
            const double impulse = -(1 + cluster.contacts[i].restitution) * rate / normal_length2(h, at.w);
            out.impulses[i] += impulse;
            push(h, at.w, impulse, at.start);
        }
        if (!closes) return out;
    }
    out.impulses = inelastic(cluster).impulses;
    out.capped = true;
    return out;
}

}  // namespace carom
