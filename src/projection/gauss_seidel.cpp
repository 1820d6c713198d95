#include "projection/gauss_seidel.hpp"

#include <algorithm>

namespace carom {

Projection gauss_seidel(const ProjectionProblem& problem, int sweeps, std::vector<double> multipliers)
{
    Projection out{problem.start, std::move(multipliers), false, 0};
    const std::size_t count = problem.half_spaces.size();
    std::vector<double> length2(count);
    for (std::size_t i = 0; i < count; ++i) {
        length2[i] = normal_length2(problem.half_spaces[i], problem.w);
        if (out.multipliers[i] != 0) push(problem.half_spaces[i], problem.w, out.multipliers[i], out.point);
    }
    for (int sweep = 0; sweep < sweeps && !out.complete; ++sweep) {
        out.complete = true;
        ++out.steps;
        for (std::size_t j = 0; j < count; ++j) {
            const std::size_t i = sweep % 2 == 0 ? j : count - 1 - j;
            const HalfSpace& h = problem.half_spaces[i];
            const double rate = slack(h, out.point);
            const double satisfying = out.multipliers[i] - rate / length2[i];
            const double next = h.is_equality ? satisfying : std::max(0.0, satisfying);
            const double change = next - out.multipliers[i];
            if (change == 0) continue;
            if (rate < -problem.tolerance || rate > problem.tolerance) out.complete = false;
            push(h, problem.w, change, out.point);
            out.multipliers[i] = next;
        }
    }
    return out;
}

}  // namespace carom
