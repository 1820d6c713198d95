/// \file
/// The pair law of all contacts at once, again and again. For teaching: impulses that should share a body's motion add
/// up instead, so that energy may be gained.
///
/// Guarantee: impulses push, momentum is kept, symmetric scenes stay symmetric, and where it ends nothing closes.
/// Energy is not kept. After 100 + 10 m rounds contacts with e = 0 that still close are closed together, for that is
/// where they come to; where others close, or with a million times the energy, the response is the inelastic one.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
#include "impact/pair_sweeps.hpp"
#include "impact/tolerances.hpp"

#include <numeric>

namespace carom {

NormalImpact jacobi(const ContactProblem& cluster)
{
    const ProjectionProblem problem = projection_problem(cluster);
    const std::size_t count = cluster.contacts.size();
    const double eps = closing_tolerance * largest_speed(problem.start);
    const double energy = kinetic_energy(cluster, problem.start);
    const int most = usual_rounds + usual_rounds_each * static_cast<int>(count);
    PairSweeps state{problem.start, std::vector<double>(count, 0.0), 0};
    NormalImpact out;
    std::vector<char> hit(count, 0);
    for (bool closes = true; closes && kinetic_energy(cluster, state.velocities) <= too_much_energy * energy;) {
        if (out.rounds == most) {
            std::vector<int> all(count);
            std::iota(all.begin(), all.end(), 0);
            out.capped = !close_for_good(cluster, all, problem.w, hit, state);
            break;
        }
        const std::vector<Vec3> before = state.velocities;
        closes = false;
        for (std::size_t i = 0; i < count; ++i) {
            const HalfSpace& h = problem.half_spaces[i];
            const double rate = slack(h, before);
            if (rate >= -eps) continue;
            closes = true;
            if (out.rounds + recent_rounds >= most) hit[i] = 1;
            const double impulse = -(1 + cluster.contacts[i].restitution) * rate / normal_length2(h, problem.w);
            state.impulses[i] += impulse;
            push(h, problem.w, impulse, state.velocities);
        }
        out.rounds += closes ? 1 : 0;
    }
    out.capped = out.capped || !(kinetic_energy(cluster, state.velocities) <= too_much_energy * energy);
    if (out.capped) return without_end(cluster, std::move(out));
    out.impulses = std::move(state.impulses);
    return out;
}

}  // namespace carom
