/// \file
/// Space in cells, over a slab of time: who may be near whom. Each flight is entered in every cell that it sweeps in
/// the slab; one level of cells a power of two of the radius, so that large and small spheres do not disturb each
/// other.
#pragma once

#include "verify/tolerances.hpp"

#include <carom/types.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace carom::verification {

/// Box that a centre sweeps [cells of the run].
struct Box {
    Vec3 low, high;
};

class Cells {
public:
    explicit Cells(const std::vector<double>& radii);

    /// Forget all entries.
    void clear();
    /// \param radius of the ball around the centre, which may be larger than the sphere's
    void enter(BodyId body, const Box& box, double radius);
    /// Cells entered since the last `clear`; who sweeps too many to list them counts for as many as could have been.
    std::size_t entries() const
    {
        std::size_t n = entries_.size();
        for (const Level& level : levels_) n += level.wide.size() * static_cast<std::size_t>(most_cells);
        return n;
    }
    double cell_size(BodyId body) const { return levels_[level_[static_cast<std::size_t>(body)]].size; }

    /// Everybody who may come within touch of a ball of this radius that sweeps the box; nobody twice.
    template <class Visit>
    void visit(const Box& box, double radius, const Visit& visit);

private:
    struct Level {
        double size = 1;                    ///< >= the largest diameter in it
        double largest_radius = 0;          ///< entered in this slab
        std::vector<BodyId> members, wide;  ///< all; those that sweep too many cells to list them
    };
    struct Entry {
        BodyId body;
        std::int32_t next;
        std::uint32_t tag;  ///< of the cell: buckets are shared
    };
    struct Range {
        std::int64_t low[3], high[3];
        double count = 0;  ///< of cells
    };

    static Range range(const Box& box, double margin, double size);
    struct Place {
        std::size_t bucket;
        std::uint32_t tag;
    };
    Place place(std::size_t level, std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        // Cells in a column of z are neighbours in memory.
        std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u;
        h = (h ^ (h >> 29)) + static_cast<std::uint64_t>(y) * 0xbf58476d1ce4e5b9u + level;
        h = (h ^ (h >> 31)) * 0x94d049bb133111ebu;
        const auto up = static_cast<std::uint64_t>(z);
        return {static_cast<std::size_t>((h >> 24) + up) & mask_, static_cast<std::uint32_t>(h + up * 0x9e3779b9u)};
    }
    /// Has this query met the body before?
    bool is_new(BodyId body)
    {
        std::uint32_t& mark = marks_[static_cast<std::size_t>(body)];
        if (mark == query_) return false;
        mark = query_;
        return true;
    }

    std::vector<Level> levels_;
    std::vector<std::uint8_t> level_;  ///< by body
    std::vector<std::int32_t> heads_;  ///< by bucket
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> marks_;
    std::uint32_t query_ = 0;
    std::size_t mask_ = 0;
};

template <class Visit>
void Cells::visit(const Box& box, double radius, const Visit& visit)
{
    if (++query_ == 0) {
        std::fill(marks_.begin(), marks_.end(), 0);
        query_ = 1;
    }
    for (std::size_t k = 0; k < levels_.size(); ++k) {
        const Level& level = levels_[k];
        const Range r = range(box, radius + level.largest_radius, level.size);
        if (!(r.count <= static_cast<double>(level.members.size()))) {
            for (const BodyId body : level.members) visit(body);
            continue;
        }
        for (const BodyId body : level.wide)
            if (is_new(body)) visit(body);
        for (std::int64_t x = r.low[0]; x <= r.high[0]; ++x)
            for (std::int64_t y = r.low[1]; y <= r.high[1]; ++y)
                for (std::int64_t z = r.low[2]; z <= r.high[2]; ++z) {
                    const Place cell = place(k, x, y, z);
                    for (std::int32_t e = heads_[cell.bucket]; e >= 0;) {
                        const Entry& entry = entries_[static_cast<std::size_t>(e)];
                        e = entry.next;
                        if (entry.tag == cell.tag && is_new(entry.body)) visit(entry.body);
                    }
                }
    }
}

}  // namespace carom::verification
