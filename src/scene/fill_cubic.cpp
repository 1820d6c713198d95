#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "scene/fill_patterns.hpp"
#include "scene/tolerances.hpp"

namespace carom {

namespace {

using Sites = std::array<std::size_t, 3>;

// Numbers of sites along the axes. The spacing narrows from one admissible value to the next until there are enough
// sites: at each value one axis (or several that tie) gets a site more. It ends, for the product grows by one at least.
Sites lattice(const Vec3& size, std::size_t count)
{
    Sites n{1, 1, 1};
    while (n[0] * n[1] * n[2] < count) {
        Vec3 next;
        for (int i = 0; i < 3; ++i) next[i] = size[i] / static_cast<double>(n[static_cast<std::size_t>(i)] + 1);
        const double spacing = next.maxCoeff();
        for (int i = 0; i < 3; ++i)
            if (next[i] >= spacing * cubic_tie) ++n[static_cast<std::size_t>(i)];
    }
    return n;
}

}  // namespace

Places place(const CubicPattern& cubic, const std::vector<double>& radii)
{
    const Vec3 size = cubic.region.max - cubic.region.min;
    const Sites n = lattice(size, radii.size());
    const Vec3 cell(size.x() / static_cast<double>(n[0]), size.y() / static_cast<double>(n[1]),
                    size.z() / static_cast<double>(n[2]));
    const double largest = *std::max_element(radii.begin(), radii.end());
    Places places;
    if (2 * largest > cell.minCoeff()) {
        places.problem = "/count: " + std::to_string(radii.size()) + " spheres of diameter " + to_text(2 * largest) +
                         " do not fit: the lattice spacing is " + to_text(cell.minCoeff(), 4) +
                         " (take fewer or smaller ones, or a larger region)";
        return places;
    }
    places.centres.reserve(radii.size());
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const Vec3 site(static_cast<double>(k % n[0]) + 0.5, static_cast<double>(k / n[0] % n[1]) + 0.5,
                        static_cast<double>(k / n[0] / n[1]) + 0.5);
        places.centres.push_back(cubic.region.min + site.cwiseProduct(cell));
    }
    return places;
}

}  // namespace carom
