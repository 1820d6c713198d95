#include "impact/pair_sweeps.hpp"

#include "contact/contact_problem.hpp"
#include "impact/exact_steps.hpp"
#include "impact/operators.hpp"
#include "impact/tolerances.hpp"

#include <algorithm>
#include <iterator>

namespace carom {

namespace {

double speed_of(const Contact& contact, const std::vector<Vec3>& velocities)
{
    const double a = velocities[static_cast<std::size_t>(contact.a)].cwiseAbs().maxCoeff();
    if (!contact.b) return a;
    return std::max(a, velocities[static_cast<std::size_t>(*contact.b)].cwiseAbs().maxCoeff());
}

/// The bound on impulses in a cluster.
int most_impulses(const ContactProblem& cluster)
{
    return pair_impulses + pair_impulses_each * static_cast<int>(cluster.contacts.size());
}

ProjectionProblem problem_of(const ContactProblem& cluster, std::span<const int> contacts,
                             std::span<const double> inverse_masses, const PairSweeps& state)
{
    ProjectionProblem out{state.velocities, {inverse_masses.begin(), inverse_masses.end()}, {}, 0};
    for (const int i : contacts) {
        const Contact& contact = cluster.contacts[static_cast<std::size_t>(i)];
        out.half_spaces.push_back({contact.a, contact.b, contact.normal, 0});
    }
    out.tolerance = projection_tolerance * largest_speed(velocities_before(cluster));
    return out;
}

/// One impulse after the other. \param hit out: by contact, whether it got one of the last as many as there are
bool sweep(const ContactProblem& cluster, std::span<const int> contacts, std::span<const double> inverse_masses,
           PairSweeps& state, std::vector<char>& hit)
{
    const int most = most_impulses(cluster);
    const double least = collapsed * largest_speed(state.velocities);
    for (bool closes = true; closes;) {
        closes = false;
        for (const int index : contacts) {
            const auto i = static_cast<std::size_t>(index);
            const Contact& contact = cluster.contacts[i];
            const double rate = closing_rate(contact, state.velocities);
            // Against the speeds of now: in a collapse all of them shrink together.
            if (rate >= -closing_tolerance * speed_of(contact, state.velocities) || rate > -least) continue;
            if (state.count >= most) return false;
            closes = true;
            const auto a = static_cast<std::size_t>(contact.a);
            const double w_a = inverse_masses[a];
            const double w_b = contact.b ? inverse_masses[static_cast<std::size_t>(*contact.b)] : 0;
            const double impulse = -(1 + contact.restitution) * rate / (w_a + w_b);
            state.velocities[a] += (w_a * impulse) * contact.normal;
            if (contact.b) state.velocities[static_cast<std::size_t>(*contact.b)] -= (w_b * impulse) * contact.normal;
            state.impulses[i] += impulse;
            ++state.count;
            if (state.count + static_cast<int>(contacts.size()) >= most) hit[i] = 1;
        }
    }
    return true;
}

/// The same in double-double, periods at once.
bool sweep_exactly(const ContactProblem& cluster, std::span<const int> contacts, const ProjectionProblem& problem,
                   PairSweeps& state)
{
    ExactSteps steps(problem, closing_in_projections * problem.tolerance);
    const int most = most_impulses(cluster), all = static_cast<int>(contacts.size());
    std::vector<int> open;
    bool ends = true;
    for (int i = 0, quiet = 0; quiet < all && ends; i = (i + 1) % all, ++quiet) {
        if (!steps.closes(i)) {
            open.push_back(i);
            continue;
        }
        const Contact& contact = cluster.contacts[static_cast<std::size_t>(contacts[static_cast<std::size_t>(i)])];
        ends = steps.take_and_repeat({{i}, std::move(open), 1 + contact.restitution}) && ++state.count <= most;
        open.clear();
        quiet = -1;
    }
    if (!ends) return false;
    const std::vector<double> impulses = steps.impulses();
    for (std::size_t k = 0; k < contacts.size(); ++k)
        state.impulses[static_cast<std::size_t>(contacts[k])] += impulses[k];
    state.velocities = steps.vectors();
    return true;
}

}  // namespace

bool sweep_pairs(const ContactProblem& cluster, std::span<const int> contacts, std::span<const double> inverse_masses,
                 PairSweeps& state)
{
    if (contacts.empty()) return true;
    const ProjectionProblem problem = problem_of(cluster, contacts, inverse_masses, state);
    const bool exact = contacts.size() <= most_exact, stiff = exact && is_stiff(problem);
    PairSweeps one_by_one = state;
    std::vector<char> hit(cluster.contacts.size(), 0);
    const auto ends = [&] { return sweep(cluster, contacts, inverse_masses, one_by_one, hit); };
    const bool ended = !stiff && ends();
    if (!ended && exact && sweep_exactly(cluster, contacts, problem, state)) return true;
    if (!ended && !(stiff && ends()) && !close_for_good(cluster, contacts, inverse_masses, hit, one_by_one))
        return false;
    state = std::move(one_by_one);
    return true;
}

bool close_for_good(const ContactProblem& cluster, std::span<const int> contacts,
                    std::span<const double> inverse_masses, const std::vector<char>& hit, PairSweeps& state)
{
    const ProjectionProblem all = problem_of(cluster, contacts, inverse_masses, state);
    std::vector<int> closed;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(closed),
                 [&](int i) { return hit[static_cast<std::size_t>(i)] != 0; });
    const Projection limit = nearest(problem_of(cluster, closed, inverse_masses, state));
    for (std::size_t k = 0; k < closed.size(); ++k)
        if (cluster.contacts[static_cast<std::size_t>(closed[k])].restitution > 0 || !(limit.multipliers[k] > 0))
            return false;
    const double closing = closing_in_projections * all.tolerance;
    if (std::any_of(all.half_spaces.begin(), all.half_spaces.end(),
                    [&](const HalfSpace& h) { return slack(h, limit.point) < -closing; }))
        return false;
    for (std::size_t k = 0; k < closed.size(); ++k)
        state.impulses[static_cast<std::size_t>(closed[k])] += limit.multipliers[k];
    state.velocities = limit.point;
    return true;
}

}  // namespace carom
