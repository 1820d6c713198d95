/// \file
/// Broad phase for many spheres that are close to each other: a list of neighbours for each. A list is made from where
/// bodies were when they were filed last, and holds as long as no body is further from there than the escape radius;
/// then it is filed anew (Verlet, Phys. Rev. 159, 98 (1967), with events in place of steps).
#pragma once

#include "broad/cell_grid.hpp"

#include <span>

namespace carom {

class NeighbourLists {
public:
    static constexpr bool bodies_leave = true, has_lists = true;

    /// \param origin from which positions are counted: they are within 2^30 of
    /// the reaches of it. A place of a cell alone \param reaches by body: two
    /// bodies must know each other at distances of their centres up to the sum of
    /// theirs [length] \param shell by which lists reach further, > 0 [length]
    NeighbourLists(const Frame& frame, const Place& origin, const std::vector<Place>& places,
                   std::vector<double> reaches, double shell);

    std::span<const BodyId> of(BodyId body) const
    {
        const auto i = static_cast<std::size_t>(body);
        return {lists_.data() + i * room_, counts_[i]};
    }
    template <class Visit>
    void neighbours(BodyId body, Visit&& visit) const
    {
        for (const BodyId other : of(body)) visit(other);
    }
    /// Others whose centres are within twice the largest sum of reaches, and some more.
    template <class Visit>
    void wide_neighbours(BodyId body, Visit&& visit) const
    {
        grid_.wide_neighbours(body, visit);
    }

    /// Files a body at a position from the origin, and follows in the lists of others.
    void file(BodyId body, const Vec3& position);

    const Place& origin() const { return origin_; }
    /// The position at which the body was filed last, from the origin [length].
    const Vec3& centre(BodyId body) const { return centres_[static_cast<std::size_t>(body)]; }
    /// Distance from there up to which a body is in reach of others while it is filed there [length].
    double reach(BodyId body) const { return reaches_[static_cast<std::size_t>(body)]; }
    /// Distance from there at which a body is to be filed anew [length].
    double escape_radius() const { return escape_radius_; }

private:
    bool is_near(const Vec3& centre, double reach, BodyId other) const;
    void remove(BodyId from, BodyId other);
    void add(BodyId to, BodyId other);

    Place origin_;
    CellGrid grid_;                ///< of centres
    std::vector<double> reaches_;  ///< by body, with half of the shell [length]
    double escape_radius_;
    std::vector<Vec3> centres_;  ///< by body, from the origin [length]
    std::vector<std::uint32_t> counts_;
    std::size_t room_;  ///< for neighbours of a body
    std::vector<BodyId> lists_;
};

}  // namespace carom
