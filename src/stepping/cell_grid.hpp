/// \file
/// Overlapping pairs among many spheres, in time proportional to their number wherever they are.
///
/// Space is cut into cubes of a little more than the largest diameter, so partners lie in adjacent cubes. Cube (x, y,
/// z) is stored at (x + A y + A^2 z) mod M with M a power of two, at least four times the number of spheres, and A odd,
/// near the cube root of M: an ordinary grid whose rows are wound around a ring. Spheres far away cost no memory; cubes
/// that share a place only add a test; and three adjacent cubes of a row are one contiguous range. (This project's
/// own.)
#pragma once

#include "stepping/contact.hpp"
#include "stepping/tolerances.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace carom::stepping {

class CellGrid {
public:
    CellGrid(std::size_t spheres, double largest_radius);

    /// Sort the spheres into cells. No allocation after the first call.
    void build(const std::vector<Vec3>& position, const std::vector<double>& radius);

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

    /// Calls on_candidate(j) for each sphere whose centre was, at build, within the largest diameter of p, and for some
    /// others.
    template <class OnCandidate>
    void for_each_near(const Vec3& p, OnCandidate&& on_candidate) const
    {
        for (std::uint32_t k = 0; k < far_; ++k) on_candidate(id_[far_begin_ + k]);
        std::uint32_t cell = 0;
        if (!find_cell(p, cell)) {
            for (std::uint32_t k = 0; k < near_; ++k) on_candidate(id_[k]);
            return;
        }
        for (const std::uint32_t row : rows_around_) {
            const std::uint32_t first = (cell + row) & mask_;
            for (std::uint32_t k = start_[first]; k < start_[first + 3]; ++k) on_candidate(id_[k]);
        }
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

    /// False for places so far out (or not finite) that cells of this size cannot be told apart.
    bool find_cell(const Vec3& p, std::uint32_t& cell) const;

    template <class OnOverlap>
    std::int64_t scan(std::uint32_t k, std::uint32_t begin, std::uint32_t end, OnOverlap&& on_overlap) const
    {
        for (std::uint32_t m = begin; m < end; ++m)
            if (overlap(entry_[k], entry_[m])) on_overlap(id_[k], id_[m]);
        return static_cast<std::int64_t>(end) - static_cast<std::int64_t>(begin);
    }

    double per_cell_;  ///< 1 / edge [1/length]
    std::uint32_t mask_;
    std::uint32_t stride_y_, stride_z_;
    std::array<std::uint32_t, 4> rows_ahead_;   ///< distance to the first cell of each row ahead, modulo M
    std::array<std::uint32_t, 9> rows_around_;  ///< the same for all rows around
    std::uint32_t near_ = 0, far_ = 0, far_begin_ = 0;
    std::vector<std::uint32_t> start_;          ///< per cell: its first entry; cells M, M + 1 repeat cells 0, 1
    std::vector<std::uint32_t> cell_of_entry_;  ///< of the near spheres, in cell order
    std::vector<std::uint32_t> cell_of_sphere_;
    std::vector<BodyId> id_;
    std::vector<Entry> entry_;  ///< near spheres in cell order, repeats of cells 0 and 1, far spheres
};

}  // namespace carom::stepping
