#include "math/project.hpp"

#include "math/components.hpp"
#include "math/dual_active_set.hpp"

#include <numeric>

namespace carom {

namespace {

ProjectionProblem part_of(const ProjectionProblem& whole, const Component& part, std::vector<int>& local)
{
    ProjectionProblem out;
    out.tolerance = whole.tolerance;
    for (std::size_t k = 0; k < part.vectors.size(); ++k) {
        const auto index = static_cast<std::size_t>(part.vectors[k]);
        local[index] = static_cast<int>(k);
        out.start.push_back(whole.start[index]);
        out.w.push_back(whole.w[index]);
    }
    for (const int i : part.half_spaces) {
        HalfSpace h = whole.half_spaces[static_cast<std::size_t>(i)];
        h.a = local[static_cast<std::size_t>(h.a)];
        if (h.b >= 0) h.b = local[static_cast<std::size_t>(h.b)];
        out.half_spaces.push_back(h);
    }
    return out;
}

bool is_satisfied(const ProjectionProblem& problem, const Component& part)
{
    for (const int i : part.half_spaces)
        if (slack(problem.half_spaces[static_cast<std::size_t>(i)], problem.start) < -problem.tolerance) return false;
    return true;
}

}  // namespace

Projection project(const ProjectionProblem& problem, std::span<const int> chosen)
{
    Projection out{problem.start, std::vector<double>(problem.half_spaces.size(), 0.0), true};
    std::vector<int> local(problem.start.size());
    for (const Component& part : components(problem.half_spaces, chosen, problem.start.size())) {
        if (is_satisfied(problem, part)) continue;
        if (part.half_spaces.size() == 1) {
            const auto i = static_cast<std::size_t>(part.half_spaces.front());
            const HalfSpace& h = problem.half_spaces[i];
            out.multipliers[i] = -slack(h, problem.start) / normal_length2(h, problem.w);
            push(h, problem.w, out.multipliers[i], out.point);
            continue;
        }
        const Projection solved = dual_active_set(part_of(problem, part, local)).projection;
        out.complete = out.complete && solved.complete;
        for (std::size_t k = 0; k < part.vectors.size(); ++k)
            out.point[static_cast<std::size_t>(part.vectors[k])] = solved.point[k];
        for (std::size_t k = 0; k < part.half_spaces.size(); ++k)
            out.multipliers[static_cast<std::size_t>(part.half_spaces[k])] = solved.multipliers[k];
    }
    return out;
}

Projection project(const ProjectionProblem& problem)
{
    std::vector<int> all(problem.half_spaces.size());
    std::iota(all.begin(), all.end(), 0);
    return project(problem, all);
}

}  // namespace carom
