/// \file
/// Spheres near a place while some of them are no longer where the detector sorted them.
#pragma once

#include "scene/sphere_grid.hpp"
#include "stepping/detection.hpp"

#include <cstdint>
#include <vector>

namespace carom::stepping {

class MovedSpheres {
public:
    /// \param radius of each sphere, by id [length]
    explicit MovedSpheres(const std::vector<double>& radius)
        : radius_(radius), is_moved_(radius.size()), place_(radius.size()), grid_(radius)
    {
    }

    /// All are where the detector sorted them, just now.
    void clear()
    {
        for (const BodyId i : moved_) is_moved_[index(i)] = 0;
        moved_.clear();
        grid_.clear();
    }

    void move(BodyId i, const Vec3& to)
    {
        if (is_moved_[index(i)]) {
            grid_.move(index(i), place_[index(i)], to, radius_[index(i)]);
        } else {
            grid_.insert(index(i), to, radius_[index(i)]);
            is_moved_[index(i)] = 1;
            moved_.push_back(i);
        }
        place_[index(i)] = to;
    }

    /// Calls on_candidate(j) for each sphere that may touch one of this radius at p, for none twice, in no useful
    /// order.
    template <class OnCandidate>
    void for_each_near(const Detector& detector, const Vec3& p, double radius, OnCandidate&& on_candidate) const
    {
        detector.for_each_near(p, radius, [&](BodyId j) {
            if (!is_moved_[index(j)]) on_candidate(j);
        });
        if (moved_.empty()) return;
        grid_.visit_near(p, radius, [&](std::size_t j) {
            on_candidate(static_cast<BodyId>(j));
            return true;
        });
    }

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    std::vector<double> radius_;          ///< [length]
    std::vector<std::uint8_t> is_moved_;  ///< one for each sphere
    std::vector<BodyId> moved_;
    std::vector<Vec3> place_;  ///< of those that moved: where the grid has them
    SphereGrid grid_;          ///< of those that moved
};

}  // namespace carom::stepping
