/// \file
/// Overlapping pairs among many spheres of about one size, in time proportional to their number wherever they are.
///
/// Space is cut into cubes of a little more than the largest diameter, so partners lie in adjacent cubes. Cube (x, y,
/// z) is stored at (x + A y + A^2 z) mod M with M a power of two, at least four times the number of spheres, and A odd,
/// near the cube root of M: an ordinary grid whose rows are wound around a ring. Spheres far away cost no memory; cubes
/// that share a place only add a test; and three adjacent cubes of a row are one contiguous range. (This project's
/// own.)
#pragma once

#include "stepping/contact.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace carom::stepping {

class CellGrid {
public:
    /// \param members the spheres that are sorted into cells
    /// \param largest_radius of a member [length]
    CellGrid(std::vector<BodyId> members, double largest_radius);

    /// Sort the members into cells; places that are not finite are left out, they overlap nothing. Hardly an allocation
    /// after the first call. \param position, radius of all spheres, by id
    void build(std::span<const Vec3> position, std::span<const double> radius);

    const std::vector<BodyId>& members() const { return members_; }
    double largest_radius() const { return largest_radius_; }

    /// Calls on_overlap(i, j) once for each overlapping pair, in no useful order. \return pairs tested.
    template <class OnOverlap>
    std::int64_t for_each_overlap(OnOverlap&& on_overlap) const
    {
        std::array<Candidate, most_candidates> batch;
        std::size_t count = 0;
        std::int64_t tests = 0;
        const auto gather = [&](std::uint32_t k, std::uint32_t begin, std::uint32_t end) {
            for (std::uint32_t m = 0; m < gather_width; ++m) batch[count + m] = {k, begin + m};
            if (end - begin <= gather_width) {
                count += end - begin;
            } else {
                tests += scan(k, begin, end, on_overlap);
            }
        };
        const auto test = [&] {
            for (std::size_t c = 0; c < count; ++c)
                if (overlap(entry_[batch[c].k], entry_[batch[c].m])) on_overlap(id_[batch[c].k], id_[batch[c].m]);
            tests += static_cast<std::int64_t>(count);
            count = 0;
        };
        for (std::uint32_t k = 0; k < near_; ++k) {
            if (count + ranges_a_sphere * gather_width > batch.size()) test();
            const std::uint32_t cell = cell_of_entry_[k];
            // The rest of the own cell and the next cell of the row, then the four rows ahead: each pair is met once.
            gather(k, k + 1, start_[cell + 2]);
            for (const std::uint32_t row : rows_ahead_) {
                const std::uint32_t first = (cell + row) & mask_;
                gather(k, start_[first], start_[first + 3]);
            }
        }
        test();
        for (std::uint32_t k = 0; k < far_; ++k) {
            const std::uint32_t far = far_begin_ + k;
            tests += scan(far, 0, near_, on_overlap);
            tests += scan(far, far + 1, far_begin_ + far_, on_overlap);
        }
        return tests;
    }

    /// Calls on_overlap(j) for each member that overlaps the sphere of this place and radius, once. \return pairs
    /// tested. \pre radius <= largest_radius()
    template <class OnOverlap>
    std::int64_t for_each_overlap_with(const Vec3& p, double radius, OnOverlap&& on_overlap) const
    {
        const Entry entry{p.x(), p.y(), p.z(), radius};
        std::int64_t tests = 0;
        for_each_range_near(p, [&](std::uint32_t begin, std::uint32_t end) {
            tests += end - begin;
            for (std::uint32_t k = begin; k < end; ++k)
                if (overlap(entry, entry_[k])) on_overlap(id_[k]);
        });
        return tests;
    }

    /// Calls on_candidate(j) for each member that touched, at build, a sphere of this place and radius, and for some
    /// others, for none twice.
    template <class OnCandidate>
    void for_each_near(const Vec3& p, double radius, OnCandidate&& on_candidate) const
    {
        const auto on_range = [&](std::uint32_t begin, std::uint32_t end) {
            for (std::uint32_t k = begin; k < end; ++k) on_candidate(id_[k]);
        };
        if (radius <= largest_radius_)
            for_each_range_near(p, on_range);
        else
            for_each_range_within(p, radius + largest_radius_, on_range);
    }

    /// Calls on_member(id, place, radius) for each that has a place.
    template <class OnMember>
    void for_each_member(OnMember&& on_member) const
    {
        const auto show = [&](std::uint32_t begin, std::uint32_t end) {
            for (std::uint32_t k = begin; k < end; ++k)
                on_member(id_[k], Vec3(entry_[k].x, entry_[k].y, entry_[k].z), entry_[k].radius);
        };
        show(0, near_);
        show(far_begin_, far_begin_ + far_);
    }

private:
    struct Entry {
        double x, y, z, radius;
    };
    struct Candidate {
        std::uint32_t k, m;  ///< two entries
    };

    static bool overlap(const Entry& e, const Entry& f)
    {
        return stepping::overlap(e.x - f.x, e.y - f.y, e.z - f.z, e.radius + f.radius);
    }

    /// A box of cells.
    struct CellBox {
        std::uint32_t corner = 0;             ///< stored cell of its lowest corner
        std::array<std::uint32_t, 3> size{};  ///< cells along each axis
        bool is_distinct = false;             ///< each cell of the box is stored in a place of its own
    };
    CellBox cells_within(const Vec3& p, double reach) const;

    /// False for places so far from home (or not finite) that cells of this size cannot be told apart.
    bool find_cell(const Vec3& p, std::uint32_t& cell) const;
    /// Count the members of each cell, seen from this home. \return those too far away for a cell.
    std::uint32_t count_cells(std::span<const Vec3> position, const Vec3& home);

    /// Calls on_range(begin, end) for all entries within `reach` of p, and others, for none twice.
    template <class OnRange>
    void for_each_range_within(const Vec3& p, double reach, OnRange&& on_range) const
    {
        if (far_ > 0) on_range(far_begin_, far_begin_ + far_);
        const CellBox box = cells_within(p, reach);
        if (!box.is_distinct) {
            on_range(0U, near_);
            return;
        }
        for (std::uint32_t z = 0; z < box.size[2]; ++z)
            for (std::uint32_t y = 0; y < box.size[1]; ++y) {
                const std::uint32_t first = (box.corner + y * stride_y_ + z * stride_z_) & mask_;
                const std::uint32_t last = first + box.size[0], cells = mask_ + 1;
                on_range(start_[first], start_[std::min(last, cells)]);
                if (last > cells) on_range(start_[0], start_[last - cells]);
            }
    }

    /// Calls on_range(begin, end) for the entries that may be within the largest diameter of p.
    template <class OnRange>
    void for_each_range_near(const Vec3& p, OnRange&& on_range) const
    {
        if (far_ > 0) on_range(far_begin_, far_begin_ + far_);
        std::uint32_t cell = 0;
        if (!find_cell(p, cell)) {
            on_range(0U, near_);
            return;
        }
        for (const std::uint32_t row : rows_around_) {
            const std::uint32_t first = (cell + row) & mask_;
            on_range(start_[first], start_[first + 3]);
        }
    }

    template <class OnOverlap>
    std::int64_t scan(std::uint32_t k, std::uint32_t begin, std::uint32_t end, OnOverlap&& on_overlap) const
    {
        for (std::uint32_t m = begin; m < end; ++m)
            if (overlap(entry_[k], entry_[m])) on_overlap(id_[k], id_[m]);
        return static_cast<std::int64_t>(end) - static_cast<std::int64_t>(begin);
    }

    std::vector<BodyId> members_;
    double largest_radius_;     ///< [length]
    double per_cell_;           ///< 1 / edge [1/length]
    Vec3 home_ = Vec3::Zero();  ///< where cells are counted from [length]
    std::uint32_t mask_;
    std::uint32_t stride_y_, stride_z_;
    std::array<std::uint32_t, 4> rows_ahead_;   ///< distance to the first cell of each row ahead, modulo M
    std::array<std::uint32_t, 9> rows_around_;  ///< the same for all rows around
    std::uint32_t near_ = 0, far_ = 0, far_begin_ = 0;
    std::vector<std::uint32_t> start_;          ///< per cell: its first entry; cells M, M + 1 repeat cells 0, 1
    std::vector<std::uint32_t> cell_of_entry_;  ///< of the near spheres, in cell order
    std::vector<std::uint32_t> cell_of_member_;
    std::vector<BodyId> id_;
    std::vector<Entry> entry_;  ///< near spheres in cell order, repeats of cells 0 and 1, far spheres
};

}  // namespace carom::stepping
