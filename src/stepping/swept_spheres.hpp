/// \file
/// Which spheres may meet on their paths within a substep, and which walls they may.
#pragma once

#include "stepping/hierarchical_grid.hpp"
#include "stepping/path_contacts.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace carom::stepping {

/// Each path lies in a ball around the middle of its ends. Balls of the paths on which the substep began are sorted
/// into cells; those of the few that have had a corner since are looked through one by one.
class SweptSpheres {
public:
    explicit SweptSpheres(const Scene& scene);

    /// All paths are new.
    void begin(const System& system, const StepPaths& paths);
    /// Sphere i goes on along another path from `now`.
    void change(const System& system, const StepPaths& paths, BodyId i, double now);

    /// Calls on_pair(a, b), a < b, for all that may meet, in no useful order.
    template <class OnPair>
    void for_each_pair(System& system, OnPair&& on_pair) const
    {
        if (grid_) {
            system.detector.tests +=
                grid_->for_each_overlap([&](BodyId i, BodyId j) { on_pair(std::min(i, j), std::max(i, j)); });
            return;
        }
        for (std::size_t a = 0; a < centre_.size(); ++a)
            for (std::size_t b = a + 1; b < centre_.size(); ++b) {
                ++system.detector.tests;
                if (may_meet(a, b)) on_pair(static_cast<BodyId>(a), static_cast<BodyId>(b));
            }
    }

    /// Calls on_partner(j) for each sphere that may meet sphere i, once, in no useful order.
    template <class OnPartner>
    void for_each_partner(System& system, BodyId i, OnPartner&& on_partner) const
    {
        const auto at = static_cast<std::size_t>(i);
        const auto test = [&](BodyId j) {
            if (j == i) return;
            ++system.detector.tests;
            if (may_meet(at, static_cast<std::size_t>(j))) on_partner(j);
        };
        if (!grid_) {
            for (std::size_t j = 0; j < centre_.size(); ++j) test(static_cast<BodyId>(j));
            return;
        }
        grid_->for_each_near(centre_[at], radius_[at], [&](BodyId j) {
            if (!is_changed_[static_cast<std::size_t>(j)]) test(j);
        });
        for (const BodyId j : changed_) test(j);
    }

    bool may_meet(const Wall& wall, BodyId i) const
    {
        return overlap(wall, centre_[static_cast<std::size_t>(i)], radius_[static_cast<std::size_t>(i)]);
    }

private:
    bool may_meet(std::size_t a, std::size_t b) const
    {
        const Vec3 d = centre_[a] - centre_[b];
        return overlap(d.x(), d.y(), d.z(), radius_[a] + radius_[b]);
    }
    void enclose(const System& system, const StepPaths& paths, std::size_t i, double now);

    bool uses_grid_;
    std::vector<Vec3> centre_;    ///< of the ball around a path [length]
    std::vector<double> radius_;  ///< [length]
    std::vector<std::uint8_t> is_changed_;
    std::vector<BodyId> changed_;
    std::optional<HierarchicalGrid> grid_;  ///< of the balls at the begin of the substep
};

}  // namespace carom::stepping
