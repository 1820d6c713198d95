/// \file
/// Generalized reflections: several elastic contacts at once, every one of which may break away, symmetric scenes stay
/// symmetric, energy and momentum are kept.
///
/// Smith, Kaufman, Vouga, Tamstorf and Grinspun, Reflections on simultaneous impact, ACM Transactions on Graphics 31
/// (2012), https://doi.org/10.1145/2185520.2185602: rounds u <- 2 P_V(u) - u over the contacts V that close, P_V the
/// projection on the velocities that close none of V, in the metric of kinetic energy. This project's, in the spirit of
/// Vouga et al., All's well that ends well, ACM Transactions on Graphics 36 (2017),
/// https://doi.org/10.1145/3072959.3073689: the jam test, the bound on rounds and the blend of mixed restitution.
///
/// Guarantee: nothing closes faster than 1e-9 of the largest speed before; impulses push; momentum is kept; energy is
/// never gained. It ends: where unit normals a_i allow w, |w| = 1, with a_i.w >= delta > 0, each round raises w.u by
/// 2 delta eps at least while it is bounded by |u|; where they do not, that set is jammed: its bodies cannot move
/// apart, nor rebound from each other, and it stays closed. A light body between two of M times its mass takes some
/// 3 M^(1/2) rounds: where two contacts close in turn, and no other could, these are taken at once (turns.hpp). Rounds
/// are bounded all the same, by 100 + 10 min(m, 100), where all e = 1 by a million / m; beyond, the response is the
/// inelastic one.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
#include "impact/jam.hpp"
#include "impact/tolerances.hpp"
#include "impact/turns.hpp"

#include "projection/project.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace carom {

namespace {

/// Bound of the rounds, for elastic clusters a far one.
int most_rounds(std::size_t contacts, bool elastic)
{
    const int usual = usual_rounds + usual_rounds_each * static_cast<int>(std::min(contacts, hardest_cluster));
    return elastic ? std::max(usual, static_cast<int>(elastic_rounds / contacts)) : usual;
}

struct Rounds {
    std::vector<double> impulses;
    int rounds = 0;
    bool ended = false;
    std::vector<char> recent;  ///< contacts with an impulse in the last rounds
};

class Reflections {
public:
    explicit Reflections(const ProjectionProblem& problem)
        : problem_(problem), eps_(closing_in_projections * problem.tolerance), jammed_(problem.half_spaces.size(), 0)
    {
    }

    NormalImpact solve(bool jam_test, bool elastic)
    {
        NormalImpact out;
        Rounds rounds;
        if (jam_test) {
            rounds = run(rounds_before_jam_test);
            // Every test but the last marks a contact; those that are marked already may hold others closed.
            while (!rounds.ended && mark_jammed(problem_, asked(rounds.recent), jammed_)) {
                out.jammed = true;
                rounds = run(rounds_before_jam_test);
            }
        }
        if (!rounds.ended) rounds = run(most_rounds(jammed_.size(), elastic));
        out.impulses = std::move(rounds.impulses);
        out.rounds = rounds.rounds;
        out.capped = !rounds.ended;
        return out;
    }

private:
    /// Rounds u <- 2 P_V(u) - u until V is empty. A jammed set D is in every V and stays closed: u <- P_D(u) follows
    /// each round.
    Rounds run(int most)
    {
        ProjectionProblem at = problem_;
        Rounds out{std::vector<double>(jammed_.size(), 0.0), 0, false, std::vector<char>(jammed_.size(), 0)};
        close_jammed(at, out.impulses);
        std::array<std::vector<int>, 2> before;  // what closed in the last round and in the one before it
        for (; out.rounds < most; ++out.rounds) {
            const std::vector<int> closing = closing_contacts(at);
            if (closing.empty()) {
                out.ended = true;
                break;
            }
            if (closing == before[1] && closing.size() == 1 && before[0].size() == 1)
                take_turns(closing.front(), before[0].front(), at, out.impulses);
            before[1] = std::exchange(before[0], closing);
            const std::vector<double> multipliers = project(at, closing).multipliers;
            for (std::size_t i = 0; i < multipliers.size(); ++i) {
                if (multipliers[i] == 0) continue;
                out.impulses[i] += 2 * multipliers[i];
                if (out.rounds >= most - recent_rounds) out.recent[i] = 1;
                push(at.half_spaces[i], at.w, 2 * multipliers[i], at.start);
            }
            close_jammed(at, out.impulses);
        }
        return out;
    }

    /// Takes many rounds of two contacts at once, if that many are to come. The next of `first` is due then.
    void take_turns(int first, int second, ProjectionProblem& at, std::vector<double>& impulses) const
    {
        const std::optional<Turns> many = turns(at, first, second, eps_);
        if (!many) return;
        for (const auto& [contact, multiplier] : {std::pair{first, many->first}, std::pair{second, many->second}}) {
            const auto i = static_cast<std::size_t>(contact);
            impulses[i] += multiplier;
            push(at.half_spaces[i], at.w, multiplier, at.start);
        }
    }

    std::vector<int> asked(const std::vector<char>& recent) const
    {
        std::vector<int> out;
        for (std::size_t i = 0; i < jammed_.size(); ++i)
            if (jammed_[i] || recent[i] || jammed_.size() <= asked_as_a_whole) out.push_back(static_cast<int>(i));
        return out;
    }

    std::vector<int> closing_contacts(const ProjectionProblem& at) const
    {
        std::vector<int> out;
        bool any = false;
        for (std::size_t i = 0; i < jammed_.size(); ++i) {
            const bool closes = slack(at.half_spaces[i], at.start) < -eps_;
            if (closes || jammed_[i]) out.push_back(static_cast<int>(i));
            any = any || (closes && !jammed_[i]);
        }
        if (!any) out.clear();
        return out;
    }

    void close_jammed(ProjectionProblem& at, std::vector<double>& impulses) const
    {
        std::vector<int> set;
        for (std::size_t i = 0; i < jammed_.size(); ++i)
            if (jammed_[i]) set.push_back(static_cast<int>(i));
        if (set.empty()) return;
        const Projection closed = project(at, set);
        for (const int i : set)
            impulses[static_cast<std::size_t>(i)] += closed.multipliers[static_cast<std::size_t>(i)];
        at.start = closed.point;
    }

    const ProjectionProblem& problem_;
    double eps_;
    std::vector<char> jammed_;
};

bool have_one_restitution(const ContactProblem& cluster)
{
    const double first = cluster.contacts.front().restitution;
    return std::all_of(cluster.contacts.begin(), cluster.contacts.end(),
                       [first](const Contact& contact) { return contact.restitution == first; });
}

/// Restitution of the whole: the mean over the contacts that close, and do not open when all are inelastic, with the
/// energy m_red c^2 / 2 of the closing as weight. (The inelastic multipliers are no weights: they need not be unique,
/// and the outcome would depend on the order of contacts.) \param without inelastic velocities
double blended_restitution(const ContactProblem& cluster, const ProjectionProblem& problem,
                           std::span<const Vec3> without)
{
    double sum = 0, weighted = 0;
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
        const HalfSpace& h = problem.half_spaces[i];
        if (slack(h, without) > closing_in_projections * problem.tolerance) continue;
        const double closing = std::max(0.0, -slack(h, problem.start));
        const double energy = closing * closing / normal_length2(h, problem.w);
        sum += energy;
        weighted += cluster.contacts[i].restitution * energy;
    }
    return sum > 0 ? weighted / sum : 0;
}

}  // namespace

NormalImpact reflections(const ContactProblem& cluster, const ReflectionsOptions& options)
{
    const ProjectionProblem problem = projection_problem(cluster);
    std::optional<Projection> without;
    if (!have_one_restitution(cluster) || cluster.contacts.front().restitution < 1) without = project(problem);
    const double e = have_one_restitution(cluster) ? cluster.contacts.front().restitution
                                                   : blended_restitution(cluster, problem, without->point);
    NormalImpact out;
    out.rounds = 1;
    if (e > 0) out = Reflections(problem).solve(options.jam_test, e == 1);
    if (e == 1 && !out.capped) return out;
    if (!without) without = project(problem);
    if (e == 0 || out.capped) {
        out.impulses = std::move(without->multipliers);
        return out;
    }
    for (std::size_t i = 0; i < out.impulses.size(); ++i)
        out.impulses[i] = e * out.impulses[i] + (1 - e) * without->multipliers[i];
    return out;
}

}  // namespace carom
