/// \file
/// Who is near a sphere? One hash grid for each size class (radii within a factor of two), so that a mix of sizes costs
/// no more than equal ones.
#pragma once

#include "scene/tolerances.hpp"

#include <array>
#include <carom/types.hpp>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace carom {

/// Indices in the order of falling radius, equal ones as they were: the order in which a SphereGrid wants its spheres.
std::vector<std::size_t> largest_first(const std::vector<double>& radii);

class SphereGrid {
public:
    /// \pre radius > 0, not larger than that of any sphere before it.
    void insert(std::size_t sphere, const Vec3& position, double radius);

    /// Calls visit(sphere) for each inserted sphere that may overlap this one, and for some that do not, until it
    /// returns false. Fast if `radius` is not larger than that of any inserted sphere.
    template <class Visit>
    void visit_near(const Vec3& position, double radius, Visit&& visit) const
    {
        for (const auto& level : levels_) {
            const double reach = (radius + level.radius) * (1 + grid_slack);
            const Cell low = cell_of(position.array() - reach, level.radius);
            const Cell high = cell_of(position.array() + reach, level.radius);
            if (cells_between(low, high) > static_cast<double>(level.newest.size())) {
                for (const auto& [cell, newest] : level.newest)
                    if (!visit_chain(newest, visit)) return;
                continue;
            }
            Cell cell;
            for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
                for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
                    for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
                        if (!visit_cell(level, cell, visit)) return;
        }
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    struct CellHash {
        std::size_t operator()(const Cell& cell) const;
    };
    struct Level {
        int exponent;   ///< radii in [2^exponent, 2^(exponent+1))
        double radius;  ///< largest of this level: the cells are two of it wide
        std::unordered_map<Cell, std::size_t, CellHash> newest;
    };
    struct Entry {
        std::size_t sphere;
        std::size_t older;  ///< next entry of the same cell
    };
    static constexpr std::size_t none = ~std::size_t{0};

    static double cells_between(const Cell& low, const Cell& high);
    static Cell cell_of(const Vec3& position, double radius);

    template <class Visit>
    bool visit_cell(const Level& level, const Cell& cell, Visit& visit) const
    {
        const auto found = level.newest.find(cell);
        return found == level.newest.end() || visit_chain(found->second, visit);
    }

    template <class Visit>
    bool visit_chain(std::size_t newest, Visit& visit) const
    {
        for (std::size_t e = newest; e != none; e = entries_[e].older)
            if (!visit(entries_[e].sphere)) return false;
        return true;
    }

    std::vector<Level> levels_;
    std::vector<Entry> entries_;
};

}  // namespace carom
