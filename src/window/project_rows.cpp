#include "window/project_rows.hpp"

#include "window/interior_point.hpp"

#include <algorithm>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

}  // namespace

int project_rows(std::vector<RelaxationRow>& rows, std::span<const Vec3> goal, std::span<const double> inverse_masses,
                 double change)
{
    ProjectionProblem problem;
    std::vector<int> number(goal.size(), -1);
    for (std::size_t i = 0; i < goal.size(); ++i) {
        if (!(inverse_masses[i] > 0)) continue;
        number[i] = static_cast<int>(problem.start.size());
        problem.start.push_back(goal[i]);
        problem.w.push_back(inverse_masses[i]);
    }
    double scale = change;
    for (const RelaxationRow& row : rows) {
        HalfSpace half_space{number[at(row.a)], {}, row.normal, -row.wanted};
        if (row.weight_a > 0 && row.weight_b > 0) {
            half_space.b = number[at(row.b)];
        } else if (row.weight_a > 0) {
            half_space.offset -= row.normal.dot(goal[at(row.b)]);
        } else {
            half_space.a = number[at(row.b)];
            half_space.normal = -row.normal;
            half_space.offset += row.normal.dot(goal[at(row.a)]);
        }
        const double missing = -slack(half_space, problem.start);
        scale = std::max(scale, missing / std::sqrt(normal_length2(half_space, problem.w)));
        problem.half_spaces.push_back(half_space);
    }
    if (rows.empty() || !(scale > 0)) {
        for (RelaxationRow& row : rows) row.multiplier = 0;
        return 0;
    }
    const Projection solved = interior_point(problem, scale);
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k].multiplier = solved.multipliers[k];
    return solved.steps;
}

}  // namespace carom
