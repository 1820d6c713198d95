#include "projection/components.hpp"

#include "math/disjoint_sets.hpp"

#include <algorithm>

namespace carom {

std::vector<Component> components(std::span<const HalfSpace> half_spaces, std::span<const int> chosen,
                                  std::size_t vectors)
{
    DisjointSets sets(vectors);
    std::vector<char> concerned(vectors, 0);
    for (const int i : chosen) {
        const HalfSpace& h = half_spaces[static_cast<std::size_t>(i)];
        concerned[static_cast<std::size_t>(h.a)] = 1;
        if (!h.b) continue;
        concerned[static_cast<std::size_t>(*h.b)] = 1;
        sets.join(static_cast<std::size_t>(h.a), static_cast<std::size_t>(*h.b));
    }
    std::vector<std::optional<std::size_t>> number(vectors);
    std::vector<Component> out;
    for (const int i : chosen) {
        std::optional<std::size_t>& mine =
            number[sets.smallest(static_cast<std::size_t>(half_spaces[static_cast<std::size_t>(i)].a))];
        if (!mine) {
            mine = out.size();
            out.emplace_back();
        }
        out[*mine].half_spaces.push_back(i);
    }
    for (std::size_t k = 0; k < vectors; ++k)
        if (concerned[k]) out[*number[sets.smallest(k)]].vectors.push_back(static_cast<int>(k));
    return out;
}

ProjectionProblem part_of(const ProjectionProblem& whole, const Component& part)
{
    ProjectionProblem out;
    out.tolerance = whole.tolerance;
    out.dependent = whole.dependent;
    for (const int k : part.vectors) {
        out.start.push_back(whole.start[static_cast<std::size_t>(k)]);
        out.w.push_back(whole.w[static_cast<std::size_t>(k)]);
    }
    const auto local = [&part](int k) {
        return static_cast<int>(std::lower_bound(part.vectors.begin(), part.vectors.end(), k) - part.vectors.begin());
    };
    for (const int i : part.half_spaces) {
        HalfSpace h = whole.half_spaces[static_cast<std::size_t>(i)];
        h.a = local(h.a);
        if (h.b) h.b = local(*h.b);
        out.half_spaces.push_back(h);
    }
    return out;
}

}  // namespace carom
