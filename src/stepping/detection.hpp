/// \file
/// Finds the contacts of the present positions.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/contact.hpp"
#include "stepping/hierarchical_grid.hpp"

#include <carom/method.hpp>

#include <optional>
#include <vector>

namespace carom::stepping {

class Detector {
public:
    /// BroadPhase::automatic decides by number of spheres.
    explicit Detector(const Scene& scene, BroadPhase broad_phase = BroadPhase::automatic);

    /// Append every pair of spheres with gap <= 0, in index order: by a, then b.
    void find_pairs(const std::vector<Vec3>& position, const std::vector<double>& radius,
                    std::vector<Contact>& contacts);
    /// Append every sphere and plane with gap <= 0, by sphere, then plane.
    void find_walls(const std::vector<Vec3>& position, const std::vector<double>& radius,
                    std::vector<Contact>& contacts);
    /// The same for one sphere.
    void find_walls_of(BodyId sphere, const Vec3& position, double radius, std::vector<Contact>& contacts);

    /// Calls on_candidate(j) for each sphere that may touch one of this radius at p: positions are those of the last
    /// find_pairs.
    template <class OnCandidate>
    void for_each_near(const Vec3& p, double radius, OnCandidate&& on_candidate) const
    {
        if (grid_) {
            grid_->for_each_near(p, radius, on_candidate);
        } else {
            for (BodyId j = 0; j < spheres_; ++j) on_candidate(j);
        }
    }

    /// Fixed spheres have no contacts with each other and with walls: nothing could come of them.
    bool is_fixed(std::size_t sphere) const { return !fixed_.empty() && fixed_[sphere] != 0; }
    bool is_wall(BodyId body) const { return body >= spheres_; }
    std::size_t walls() const { return walls_.size(); }
    const Wall& wall(BodyId body) const { return walls_[static_cast<std::size_t>(body - spheres_)]; }

    std::int64_t tests = 0;  ///< gaps examined

private:
    BodyId spheres_;
    std::vector<Wall> walls_;
    std::vector<std::uint8_t> fixed_;  ///< one for each sphere; empty if none is
    std::optional<HierarchicalGrid> grid_;
    std::vector<std::uint64_t> found_;
};

/// Largest penetration among these contacts, at least 0 [length].
double deepest_penetration(const std::vector<Contact>& contacts);

}  // namespace carom::stepping
