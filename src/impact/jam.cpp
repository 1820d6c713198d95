#include "impact/jam.hpp"

#include "impact/tolerances.hpp"
#include "projection/components.hpp"
#include "projection/dual_active_set.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

bool mark_jammed(const ProjectionProblem& problem, std::span<const int> asked, std::vector<char>& jammed)
{
    bool found = false;
    for (const Component& part : components(problem.half_spaces, asked, problem.start.size())) {
        if (part.half_spaces.size() > most_asked) continue;
        // The shortest way that opens every contact by 1, in units of its own normal, is 1/delta long.
        ProjectionProblem opening = part_of(problem, part);
        std::fill(opening.start.begin(), opening.start.end(), Vec3::Zero());
        for (std::size_t k = 0; k < part.half_spaces.size(); ++k) {
            HalfSpace& h = opening.half_spaces[k];
            const bool marked = jammed[static_cast<std::size_t>(part.half_spaces[k])] != 0;
            h.offset = marked ? 0 : -std::sqrt(normal_length2(h, opening.w));
        }
        opening.tolerance = 0;
        for (const int k : dual_active_set(opening, {1 / smallest_opening, opening_tolerance}).conflict) {
            char& mark = jammed[static_cast<std::size_t>(part.half_spaces[static_cast<std::size_t>(k)])];
            found = found || mark == 0;
            mark = 1;
        }
    }
    return found;
}

}  // namespace carom
