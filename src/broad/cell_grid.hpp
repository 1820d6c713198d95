/// \file
/// Broad phase for many spheres: a grid of cells without borders. Every sphere is filed under the cell that holds its
/// centre; two spheres whose cells differ by more than one in some axis cannot touch. Cells are stored in a table that
/// repeats itself along each axis, so a sphere may fly as far as it likes; that distant cells share an entry costs
/// tests, never a neighbour.
#pragma once

#include "broad/tolerances.hpp"
#include "flight/frame.hpp"

#include <array>
#include <vector>

namespace carom {

using Cell = std::array<std::int64_t, 3>;

class CellGrid {
public:
    /// Bodies leave what is known of them, in an event; and whether it is lists.
    static constexpr bool bodies_leave = true, has_lists = false;

    /// \param reach largest distance of two centres at which they must know each other [length]
    CellGrid(const Frame& frame, const std::vector<Place>& places, double reach);

    const Cell& cell(BodyId body) const { return cells_[static_cast<std::size_t>(body)]; }
    /// Files `body` under the next cell along `axis`, up (+1) or down (-1).
    void step(BodyId body, int axis, int direction);

    /// Files `body` under the cell of a position.
    void file_at(BodyId body, const Vec3& position);

    /// Height of a place above the lower wall of a body's cell along an axis, and below the upper one [length].
    double above_lower_wall(const Frame& frame, BodyId body, int axis, const Place& place) const;
    double below_upper_wall(const Frame& frame, BodyId body, int axis, const Place& place) const;

    /// Distance from its cell at which a body is filed anew [length]; the reach has room for it. Without it a body that
    /// turns round at a wall faster than times can tell would cross the wall for ever.
    double slack() const { return cell_slack * cell_size_; }

    /// The other bodies filed in the 27 cells around `body`, in no particular order.
    template <class Visit>
    void neighbours(BodyId body, Visit&& visit) const
    {
        visit_around<1>(body, visit);
    }
    /// The other bodies filed in the 125 cells around `body`: all whose centres are within two reaches.
    template <class Visit>
    void wide_neighbours(BodyId body, Visit&& visit) const
    {
        visit_around<2>(body, visit);
    }

private:
    std::size_t entry(const Cell& cell) const
    {
        return static_cast<std::size_t>((cell[0] & mask_[0]) | ((cell[1] & mask_[1]) << shift_[1]) |
                                        ((cell[2] & mask_[2]) << shift_[2]));
    }
    static bool same(const Cell& a, const Cell& b) { return a[0] == b[0] && a[1] == b[1] && a[2] == b[2]; }
    void file(BodyId body);
    void unfile(BodyId body);

    Cell cell_of(const Vec3& position) const;

    /// Visits the others filed at most so many cells away along each axis.
    template <int cells, class Visit>
    void visit_around(BodyId body, Visit&& visit) const
    {
        const Cell centre = cell(body);
        for (int z = -cells; z <= cells; ++z)
            for (int y = -cells; y <= cells; ++y)
                for (int x = -cells; x <= cells; ++x) {
                    const Cell here{centre[0] + x, centre[1] + y, centre[2] + z};
                    for (BodyId other = first_[entry(here)]; other != no_body;
                         other = next_[static_cast<std::size_t>(other)])
                        if (other != body && same(cells_[static_cast<std::size_t>(other)], here)) visit(other);
                }
    }

    double cell_size_;  ///< few bits, so that a wall's position is exact [length]
    std::array<std::int64_t, 3> mask_{};
    std::array<int, 3> shift_{};
    std::vector<Cell> cells_;          ///< by body
    std::vector<BodyId> first_;        ///< by table entry
    std::vector<BodyId> next_, prev_;  ///< by body: others under the same entry
};

}  // namespace carom
