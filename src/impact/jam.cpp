#include "impact/jam.hpp"

#include "math/dual_active_set.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {
/// delta: unit normals whose convex hull comes nearer to 0 than this are jammed.
constexpr double smallest_opening = 1e-7;
/// Of the openings asked for, which are 1.
constexpr double opening_tolerance = 1e-6;
}  // namespace

bool mark_jammed(const ProjectionProblem& problem, std::vector<char>& jammed)
{
    // The shortest way that opens every contact by 1, in units of its own normal, is 1/delta long.
    ProjectionProblem opening{std::vector<Vec3>(problem.start.size(), Vec3::Zero()), problem.w, problem.half_spaces, 0};
    for (std::size_t i = 0; i < jammed.size(); ++i) {
        HalfSpace& h = opening.half_spaces[i];
        h.offset = jammed[i] ? 0 : -std::sqrt(normal_length2(h, problem.w));
    }
    bool found = false;
    for (const int i : dual_active_set(opening, {1 / smallest_opening, opening_tolerance}).conflict) {
        char& mark = jammed[static_cast<std::size_t>(i)];
        found = found || mark == 0;
        mark = 1;
    }
    return found;
}

}  // namespace carom
