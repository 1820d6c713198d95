#include "stepping/cell_grid.hpp"

#include "core/expect.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::stepping {

namespace {

// In place of a cell.
constexpr std::uint32_t nowhere = 0xffffffff;
constexpr std::uint32_t far_away = nowhere - 1;

std::uint32_t cells_for(std::size_t spheres)
{
    std::uint32_t cells = fewest_cells;
    while (cells < cells_a_sphere * spheres && cells < most_cells) cells *= 2;
    return cells;
}

/// Largest integer whose cube is at most `cells`, made odd.
std::uint32_t odd_cube_root(std::uint32_t cells)
{
    std::uint64_t a = 4;
    while ((a + 1) * (a + 1) * (a + 1) <= cells) ++a;
    return static_cast<std::uint32_t>(a) | 1U;
}

/// floor(x) modulo 2^32. \pre |x| < 2^31. (Without SSE 4.1 std::floor is a call.)
std::uint32_t floor_to_cell(double x)
{
    const auto truncated = static_cast<std::int32_t>(x);
    return static_cast<std::uint32_t>(truncated - (static_cast<double>(truncated) > x));
}

}  // namespace

CellGrid::CellGrid(std::vector<BodyId> members, double largest_radius)
    : members_(std::move(members)),
      largest_radius_(largest_radius),
      per_cell_(1 / (2 * largest_radius * (1 + cell_slack))),
      mask_(cells_for(members_.size()) - 1),
      stride_y_(odd_cube_root(mask_ + 1)),
      stride_z_(stride_y_ * stride_y_),
      start_(std::size_t{mask_} + 4),
      cell_of_entry_(members_.size()),
      cell_of_member_(members_.size())
{
    CAROM_EXPECT(members_.size() < most_cells);
    const std::uint32_t y = stride_y_, z = stride_z_;
    // Unsigned wrap-around is the modulo: 2^32 is a multiple of the number of cells.
    rows_ahead_ = {y - 1, z - y - 1, z - 1, z + y - 1};
    rows_around_ = {0U - z - y - 1, 0U - z - 1, y - z - 1, 0U - y - 1, 0U - 1, y - 1, z - y - 1, z - 1, z + y - 1};
}

bool CellGrid::find_cell(const Vec3& p, std::uint32_t& cell) const
{
    const double x = (p.x() - home_.x()) * per_cell_, y = (p.y() - home_.y()) * per_cell_,
                 z = (p.z() - home_.z()) * per_cell_;
    if (!(std::abs(x) < farthest_cell && std::abs(y) < farthest_cell && std::abs(z) < farthest_cell)) return false;
    cell = (floor_to_cell(x) + floor_to_cell(y) * stride_y_ + floor_to_cell(z) * stride_z_) & mask_;
    return true;
}

CellGrid::CellBox CellGrid::cells_within(const Vec3& p, double reach) const
{
    CellBox box;
    const double margin = reach * (1 + cell_slack);
    const Vec3 low = (p - home_ - Vec3::Constant(margin)) * per_cell_;
    const Vec3 high = (p - home_ + Vec3::Constant(margin)) * per_cell_;
    // The numbers x + A y + A^2 z of a box are distinct, and so they are modulo M, where they span less than M.
    const std::array<double, 3> widest{static_cast<double>(stride_y_), static_cast<double>(stride_y_),
                                       std::floor(static_cast<double>(mask_ + 1) / static_cast<double>(stride_z_))};
    for (int axis = 0; axis < 3; ++axis) {
        const double size = std::floor(high[axis]) - std::floor(low[axis]) + 1;
        if (!(size <= widest[static_cast<std::size_t>(axis)]) ||
            !(std::abs(low[axis]) < farthest_cell && std::abs(high[axis]) < farthest_cell))
            return box;
        box.size[static_cast<std::size_t>(axis)] = static_cast<std::uint32_t>(size);
    }
    box.corner = (floor_to_cell(low.x()) + floor_to_cell(low.y()) * stride_y_ + floor_to_cell(low.z()) * stride_z_);
    box.is_distinct = true;
    return box;
}

std::uint32_t CellGrid::count_cells(std::span<const Vec3> position, const Vec3& home)
{
    home_ = home;
    std::fill(start_.begin(), start_.end(), 0U);
    std::uint32_t far = 0;
    for (std::size_t m = 0; m < members_.size(); ++m) {
        const Vec3& p = position[static_cast<std::size_t>(members_[m])];
        std::uint32_t cell = 0;
        if (find_cell(p, cell)) {
            ++start_[cell];
        } else if (p.allFinite()) {
            cell = far_away;
            ++far;
        } else {
            cell = nowhere;
        }
        cell_of_member_[m] = cell;
    }
    return far;
}

void CellGrid::build(std::span<const Vec3> position, std::span<const double> radius)
{
    const auto n = static_cast<std::uint32_t>(members_.size());
    far_ = count_cells(position, Vec3::Zero());
    if (far_ > 0) {
        // A whole scene may be far from the origin: then one of them is a better home for most.
        const auto one = std::find(cell_of_member_.begin(), cell_of_member_.end(), far_away);
        const BodyId id = members_[static_cast<std::size_t>(one - cell_of_member_.begin())];
        const std::uint32_t far_from_one = count_cells(position, position[static_cast<std::size_t>(id)]);
        far_ = far_from_one < far_ ? far_from_one : count_cells(position, Vec3::Zero());
    }
    std::uint32_t sum = 0;
    for (std::uint32_t c = 0; c <= mask_; ++c) {
        sum += start_[c];
        start_[c] = sum;
    }
    near_ = sum;
    start_[mask_ + 1] = near_;

    const std::uint32_t repeats = start_[1];  // entries of cells 0 and 1: start_ still holds the ends
    far_begin_ = near_ + repeats;
    std::uint32_t far = far_begin_ + far_;
    if (far > entry_.size()) {
        entry_.resize(far);
        id_.resize(far);
    }
    for (std::uint32_t m = n; m-- > 0;) {
        const std::uint32_t cell = cell_of_member_[m];
        if (cell == nowhere) continue;
        const std::uint32_t k = cell == far_away ? --far : --start_[cell];
        const auto i = static_cast<std::size_t>(members_[m]);
        const Vec3& p = position[i];
        entry_[k] = {p.x(), p.y(), p.z(), radius[i]};
        id_[k] = members_[m];
        if (cell != far_away) cell_of_entry_[k] = cell;
    }
    std::copy_n(entry_.begin(), repeats, entry_.begin() + near_);
    std::copy_n(id_.begin(), repeats, id_.begin() + near_);
    start_[mask_ + 2] = near_ + start_[1];
    start_[mask_ + 3] = near_ + repeats;
}

}  // namespace carom::stepping
