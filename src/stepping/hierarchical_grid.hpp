/// \file
/// Overlapping pairs among spheres of any sizes: a grid of cells for each size class, radii within a factor of two, so
/// that a large sphere among small ones costs the small ones next to nothing. (Eitz, Lixu, Hierarchical spatial hashing
/// for real-time collision detection, Shape Modeling International, 2007.)
#pragma once

#include "stepping/cell_grid.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace carom::stepping {

class HierarchicalGrid {
public:
    /// \param radius of each sphere, by id [length]
    explicit HierarchicalGrid(std::span<const double> radius);

    /// Sort the spheres into cells; places that are not finite are left out, they overlap nothing.
    /// \param position, radius by id; the radii of the construction
    void build(std::span<const Vec3> position, std::span<const double> radius);

    /// Calls on_overlap(i, j) once for each overlapping pair, in no useful order. \return pairs tested.
    template <class OnOverlap>
    std::int64_t for_each_overlap(OnOverlap&& on_overlap) const
    {
        std::int64_t tests = 0;
        for (std::size_t level = 0; level < levels_.size(); ++level) {
            tests += levels_[level].for_each_overlap(on_overlap);
            for (std::size_t larger = 0; larger < level; ++larger)
                levels_[level].for_each_member([&](BodyId i, const Vec3& p, double radius) {
                    tests += levels_[larger].for_each_overlap_with(p, radius, [&](BodyId j) { on_overlap(i, j); });
                });
        }
        return tests;
    }

    /// Calls on_candidate(j) for each sphere that touched, at build, a sphere of this place and radius, and for some
    /// others, for none twice.
    template <class OnCandidate>
    void for_each_near(const Vec3& p, double radius, OnCandidate&& on_candidate) const
    {
        for (const CellGrid& level : levels_) level.for_each_near(p, radius, on_candidate);
    }

private:
    std::vector<CellGrid> levels_;  ///< by size class, the largest first
};

}  // namespace carom::stepping
