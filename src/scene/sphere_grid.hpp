/// \file
/// Spheres near a place: one hash grid for each size class (radii within a factor of two), so that a mix of sizes costs
/// no more than equal ones. Spheres come one after the other.
#pragma once

#include "scene/tolerances.hpp"

#include <array>
#include <carom/types.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom {

/// Indices in the order of falling radius, equal ones as they were: the order in which a SphereGrid wants its spheres.
std::vector<std::size_t> largest_first(const std::vector<double>& radii);

class SphereGrid {
public:
    /// A grid of spheres that come largest first.
    SphereGrid() = default;
    /// A grid of spheres that come in any order, none larger than the largest of its size class among `radii`.
    explicit SphereGrid(const std::vector<double>& radii);

    /// \pre radius > 0, not larger than that of any sphere of its size class before it.
    void insert(std::size_t sphere, const Vec3& position, double radius);

    /// A sphere that was inserted at `from`, or moved there, is at `to` now. \pre its radius is the one it came with
    void move(std::size_t sphere, const Vec3& from, const Vec3& to, double radius);

    /// Forgets the spheres, in time proportional to their number.
    void clear();

    /// Calls visit(sphere) for each inserted sphere that may overlap this one, and for some that do not, until it
    /// returns false. Fast if `radius` is not larger than that of any inserted sphere.
    template <class Visit>
    void visit_near(const Vec3& position, double radius, Visit&& visit) const
    {
        for (const auto& level : levels_) {
            const double reach = (radius + level.radius) * (1 + grid_slack);
            const Cell low = cell_of(level, position.array() - reach);
            const Cell high = cell_of(level, position.array() + reach);
            if (cells_between(low, high) > static_cast<double>(level.entries.size())) {
                for (const Entry& entry : level.entries)
                    if (!visit(entry.sphere)) return;
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
    using Index = std::uint32_t;  ///< of an entry
    struct Entry {
        std::size_t sphere;
        Cell cell;
        Index older;  ///< next entry of the same bucket
    };
    struct Level {
        int exponent;     ///< radii in [2^exponent, 2^(exponent+1)), biased
        double radius;    ///< largest of this level: the cells are two of it wide [length]
        double per_cell;  ///< 1 / edge of a cell [1/length]
        std::vector<Entry> entries;
        std::vector<Index> newest;  ///< by bucket; the number of buckets is a power of two
    };
    static constexpr Index none = ~Index{0};

    static double cells_between(const Cell& low, const Cell& high);
    static Cell cell_of(const Level& level, const Vec3& position);

    /// Neighbours along x stand side by side; the factors are odd and without pattern (of splitmix64).
    static std::size_t bucket(const Level& level, const Cell& cell)
    {
        const auto x = static_cast<std::uint64_t>(cell[0]), y = static_cast<std::uint64_t>(cell[1]),
                   z = static_cast<std::uint64_t>(cell[2]);
        return (x + y * 0xbf58476d1ce4e5b9ULL + z * 0x94d049bb133111ebULL) & (level.newest.size() - 1);
    }
    /// (What std::array offers is a call of memcmp.)
    static bool same(const Cell& a, const Cell& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }
    /// Twice as many buckets, and each entry in its new one.
    static void grow(Level& level);
    Level& level_of(double radius);

    template <class Visit>
    static bool visit_cell(const Level& level, const Cell& cell, Visit& visit)
    {
        for (Index e = level.newest[bucket(level, cell)]; e != none;) {
            const Entry& entry = level.entries[e];
            if (same(entry.cell, cell) && !visit(entry.sphere)) return false;
            e = entry.older;
        }
        return true;
    }

    std::vector<Level> levels_;
};

}  // namespace carom
