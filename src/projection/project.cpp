#include "projection/project.hpp"

#include "projection/components.hpp"
#include "projection/dual_active_set.hpp"
#include "projection/gauss_seidel.hpp"
#include "projection/primal_dual_active_set.hpp"

#include <numeric>

namespace carom {

namespace {

bool is_satisfied(const ProjectionProblem& problem, const Component& part)
{
    for (const int i : part.half_spaces) {
        const HalfSpace& h = problem.half_spaces[static_cast<std::size_t>(i)];
        const double rate = slack(h, problem.start);
        if (h.is_equality ? rate != 0 : rate < -problem.tolerance) return false;
    }
    return true;
}

/// A set that does not settle most often does from more sweeps; the dense one always does, where it is not too dear.
Projection solve_sparse(const ProjectionProblem& part, Guess guess)
{
    std::vector<double> multipliers(part.half_spaces.size(), 0.0);
    if (guess) multipliers.assign(guess->begin(), guess->end());
    for (int n = 0; n < most_sets; ++n) {
        if (n > 0 || !guess)
            multipliers = gauss_seidel(part, n > 0 ? more_sweeps : first_sweeps, std::move(multipliers)).multipliers;
        Projection out = primal_dual_active_set(part, multipliers);
        if (out.complete) return out;
    }
    if (part.half_spaces.size() <= largest_dense) return dual_active_set(part).projection;
    return {{}, std::move(multipliers), false, 0};
}

/// The sparse set is the quicker one where it begins near its end, and the dense one where it begins with nothing.
Projection solve(const ProjectionProblem& part, Guess guess)
{
    const std::size_t count = part.half_spaces.size();
    Projection out{{}, {}, false};
    if (guess && guessed_limit < count && count <= dense_limit) out = primal_dual_active_set(part, *guess);
    if (!out.complete) out = count <= dense_limit ? dual_active_set(part).projection : solve_sparse(part, guess);
    if (!out.complete) out = gauss_seidel(part, last_sweeps, std::move(out.multipliers));
    return out;
}

}  // namespace

Projection project(const ProjectionProblem& problem, std::span<const int> chosen, Guess guess)
{
    Projection out{problem.start, std::vector<double>(problem.half_spaces.size(), 0.0), true, 0};
    for (const Component& part : components(problem.half_spaces, chosen, problem.start.size())) {
        if (is_satisfied(problem, part)) continue;
        if (part.half_spaces.size() == 1) {
            const auto i = static_cast<std::size_t>(part.half_spaces.front());
            const HalfSpace& h = problem.half_spaces[i];
            out.multipliers[i] = -slack(h, problem.start) / normal_length2(h, problem.w);
            push(h, problem.w, out.multipliers[i], out.point);
            ++out.steps;
            continue;
        }
        std::optional<std::vector<double>> part_guess;
        if (guess) {
            part_guess.emplace();
            for (const int i : part.half_spaces) part_guess->push_back((*guess)[static_cast<std::size_t>(i)]);
        }
        const Projection solved = solve(part_of(problem, part), part_guess);
        out.complete = out.complete && solved.complete;
        out.steps += solved.steps;
        for (const int k : solved.bound) out.bound.push_back(part.half_spaces[static_cast<std::size_t>(k)]);
        for (std::size_t k = 0; k < part.vectors.size(); ++k)
            out.point[static_cast<std::size_t>(part.vectors[k])] = solved.point[k];
        for (std::size_t k = 0; k < part.half_spaces.size(); ++k)
            out.multipliers[static_cast<std::size_t>(part.half_spaces[k])] = solved.multipliers[k];
    }
    return out;
}

Projection project(const ProjectionProblem& problem, Guess guess)
{
    std::vector<int> all(problem.half_spaces.size());
    std::iota(all.begin(), all.end(), 0);
    return project(problem, all, guess);
}

}  // namespace carom
