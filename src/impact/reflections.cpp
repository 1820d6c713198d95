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
/// 3 M^(1/2) rounds: rounds that repeat are taken at once (exact_steps.hpp). They are bounded all the same, by 100 + 10
/// m and a million / m; beyond, the response is the inelastic one.
#include "impact/operators.hpp"

#include "contact/contact_problem.hpp"
#include "impact/exact_steps.hpp"
#include "impact/jam.hpp"
#include "impact/tolerances.hpp"

#include "projection/project.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace carom {

namespace {

/// Bound of the rounds.
int most_rounds(std::size_t contacts)
{
    return usual_rounds + usual_rounds_each * static_cast<int>(contacts);
}

/// The same of exact ones, for stiff and for elastic clusters a far one.
int most_exact_rounds(std::size_t contacts, bool far)
{
    const int usual = most_rounds(contacts);
    return far ? std::max(usual, static_cast<int>(exact_rounds / contacts)) : usual;
}

struct Rounds {
    std::vector<double> impulses;
    std::optional<std::vector<Vec3>> velocities{};  ///< where they were exact
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
        const bool exact = jammed_.size() <= most_exact, stiff = exact && is_stiff(problem_);
        NormalImpact out;
        Rounds rounds;
        if (jam_test) {
            rounds = run(rounds_before_jam_test, stiff, Pace::one_by_one);
            // Every test but the last marks a contact; those that are marked already may hold others closed.
            while (!rounds.ended && mark_jammed(problem_, asked(rounds.recent), jammed_)) {
                out.jammed = true;
                rounds = run(rounds_before_jam_test, stiff, Pace::one_by_one);
            }
        }
        if (!rounds.ended && !(stiff && jam_test)) rounds = run(most_rounds(jammed_.size()));
        if (!rounds.ended && exact && jam_test)
            rounds = run_exactly(most_exact_rounds(jammed_.size(), stiff || elastic), Pace::at_once);
        out.impulses = std::move(rounds.impulses);
        out.velocities = std::move(rounds.velocities);
        out.rounds = rounds.rounds;
        out.capped = !rounds.ended;
        return out;
    }

private:
    Rounds run(int most, bool exact, Pace pace) const { return exact ? run_exactly(most, pace) : run(most); }

    /// Rounds u <- 2 P_V(u) - u until V is empty. A jammed set D is in every V and stays closed: u <- P_D(u) follows
    /// each round.
    Rounds run(int most) const
    {
        ProjectionProblem at = problem_;
        Rounds out = none();
        close_jammed(at, out.impulses);
        for (; out.rounds < most; ++out.rounds) {
            const std::vector<int> closing =
                closing_contacts([&](std::size_t i) { return slack(at.half_spaces[i], at.start) < -eps_; });
            if (closing.empty()) {
                out.ended = true;
                break;
            }
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

    /// The same in double-double, those that repeat at once.
    Rounds run_exactly(int most, Pace pace) const
    {
        ExactSteps steps(problem_, eps_, pace);
        Rounds out = none();
        Pushed pushed;
        bool ends = close_jammed(steps, pushed);
        for (; out.rounds < most && ends; ++out.rounds) {
            const std::vector<int> closing =
                closing_contacts([&](std::size_t i) { return steps.closes(static_cast<int>(i)); });
            if (closing.empty()) {
                out.ended = true;
                break;
            }
            Step step{closing, {}, 2};
            for (std::size_t i = 0, next = 0; i < jammed_.size(); ++i) {
                if (next < closing.size() && closing[next] == static_cast<int>(i))
                    ++next;
                else
                    step.open.push_back(static_cast<int>(i));
            }
            if (out.rounds >= most - recent_rounds)
                for (const int i : closing) out.recent[static_cast<std::size_t>(i)] = 1;
            ends = take(steps, std::move(step), pushed) && close_jammed(steps, pushed);
        }
        out.impulses = steps.impulses();
        out.velocities = steps.vectors();
        return out;
    }

    Rounds none() const
    {
        return {std::vector<double>(jammed_.size(), 0.0), {}, 0, false, std::vector<char>(jammed_.size(), 0)};
    }

    /// Pushed contacts by those that close, as they were last.
    using Pushed = std::map<std::vector<int>, std::vector<int>>;

    /// Takes a step, of those of its contacts that the projection on all of them pushes. \returns whether that ever
    /// ends
    bool take(ExactSteps& steps, Step step, Pushed& pushed) const
    {
        if (step.contacts.size() == 1) return steps.take_and_repeat(step);
        const std::vector<int> closing = step.contacts;
        const auto split = [&](const std::vector<int>& contacts) {
            step.contacts = contacts;
            step.idle.clear();
            std::copy_if(closing.begin(), closing.end(), std::back_inserter(step.idle), [&](int i) {
                return !jammed_[static_cast<std::size_t>(i)] &&
                       !std::binary_search(contacts.begin(), contacts.end(), i);
            });
        };
        if (const auto before = pushed.find(closing); before != pushed.end()) {
            split(before->second);
            if (steps.is_projection(step)) return steps.take_and_repeat(step);
        }
        ProjectionProblem at = problem_;
        at.start = steps.vectors();
        const std::vector<double> multipliers = project(at, closing).multipliers;
        std::vector<int> contacts;
        std::copy_if(closing.begin(), closing.end(), std::back_inserter(contacts),
                     [&](int i) { return multipliers[static_cast<std::size_t>(i)] > 0; });
        if (contacts.empty()) return true;
        split(contacts);
        if (!steps.is_projection(step)) {
            for (const int i : contacts) steps.push(i, step.gain * multipliers[static_cast<std::size_t>(i)]);
            return true;
        }
        pushed[closing] = contacts;
        return steps.take_and_repeat(step);
    }

    std::vector<int> asked(const std::vector<char>& recent) const
    {
        std::vector<int> out;
        for (std::size_t i = 0; i < jammed_.size(); ++i)
            if (jammed_[i] || recent[i] || jammed_.size() <= asked_as_a_whole) out.push_back(static_cast<int>(i));
        return out;
    }

    std::vector<int> closing_contacts(const auto& is_closing) const
    {
        std::vector<int> out;
        bool any = false;
        for (std::size_t i = 0; i < jammed_.size(); ++i) {
            const bool closes = is_closing(i);
            if (closes || jammed_[i]) out.push_back(static_cast<int>(i));
            any = any || (closes && !jammed_[i]);
        }
        if (!any) out.clear();
        return out;
    }

    std::vector<int> jammed() const
    {
        std::vector<int> out;
        for (std::size_t i = 0; i < jammed_.size(); ++i)
            if (jammed_[i]) out.push_back(static_cast<int>(i));
        return out;
    }

    /// \returns whether that ever ends
    bool close_jammed(ExactSteps& steps, Pushed& pushed) const
    {
        const std::vector<int> set = jammed();
        if (set.empty()) return true;
        return take(steps, {set, {}, 1, {}, true}, pushed);
    }

    void close_jammed(ProjectionProblem& at, std::vector<double>& impulses) const
    {
        const std::vector<int> set = jammed();
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
    if (!have_one_restitution(cluster) || cluster.contacts.front().restitution < 1) without = nearest(problem);
    const double e = have_one_restitution(cluster) ? cluster.contacts.front().restitution
                                                   : blended_restitution(cluster, problem, without->point);
    NormalImpact out;
    if (e > 0) out = Reflections(problem).solve(options.jam_test, e == 1);
    if (e == 1 && !out.capped) return out;
    if (e == 0) return inelastic(cluster);
    if (out.capped) return without_end(cluster, std::move(out));
    for (std::size_t i = 0; i < out.impulses.size(); ++i)
        out.impulses[i] = e * out.impulses[i] + (1 - e) * without->multipliers[i];
    if (out.velocities)
        for (std::size_t k = 0; k < out.velocities->size(); ++k)
            (*out.velocities)[k] = e * (*out.velocities)[k] + (1 - e) * without->point[k];
    return out;
}

}  // namespace carom
