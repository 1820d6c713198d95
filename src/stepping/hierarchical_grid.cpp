#include "stepping/hierarchical_grid.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace carom::stepping {

HierarchicalGrid::HierarchicalGrid(std::span<const double> radius)
{
    std::map<int, std::vector<BodyId>, std::greater<>> classes;  // by the binary exponent of the radius
    for (std::size_t i = 0; i < radius.size(); ++i) classes[std::ilogb(radius[i])].push_back(static_cast<BodyId>(i));
    for (auto& [exponent, members] : classes) {
        double largest = 0;
        for (const BodyId i : members) largest = std::max(largest, radius[static_cast<std::size_t>(i)]);
        levels_.emplace_back(std::move(members), largest);
    }
}

void HierarchicalGrid::build(std::span<const Vec3> position, std::span<const double> radius)
{
    for (CellGrid& level : levels_) level.build(position, radius);
}

}  // namespace carom::stepping
