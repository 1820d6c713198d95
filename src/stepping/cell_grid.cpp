#include "stepping/cell_grid.hpp"

#include "core/expect.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::stepping {

namespace {

constexpr std::uint32_t nowhere = 0xffffffff;

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

CellGrid::CellGrid(std::size_t spheres, double largest_radius)
    : per_cell_(1 / (2 * largest_radius * (1 + cell_slack))),
      mask_(cells_for(spheres) - 1),
      stride_y_(odd_cube_root(mask_ + 1)),
      stride_z_(stride_y_ * stride_y_),
      start_(std::size_t{mask_} + 4),
      cell_of_entry_(spheres),
      cell_of_sphere_(spheres),
      id_(2 * spheres),
      entry_(2 * spheres)
{
    CAROM_EXPECT(spheres < most_cells);
    const std::uint32_t y = stride_y_, z = stride_z_;
    // Unsigned wrap-around is the modulo: 2^32 is a multiple of the number of cells.
    rows_ahead_ = {y - 1, z - y - 1, z - 1, z + y - 1};
    rows_around_ = {0U - z - y - 1, 0U - z - 1, y - z - 1, 0U - y - 1, 0U - 1, y - 1, z - y - 1, z - 1, z + y - 1};
}

bool CellGrid::find_cell(const Vec3& p, std::uint32_t& cell) const
{
    const double x = p.x() * per_cell_, y = p.y() * per_cell_, z = p.z() * per_cell_;
    if (!(std::abs(x) < farthest_cell && std::abs(y) < farthest_cell && std::abs(z) < farthest_cell)) return false;
    cell = (floor_to_cell(x) + floor_to_cell(y) * stride_y_ + floor_to_cell(z) * stride_z_) & mask_;
    return true;
}

void CellGrid::build(const std::vector<Vec3>& position, const std::vector<double>& radius)
{
    const auto n = static_cast<std::uint32_t>(position.size());
    CAROM_EXPECT(cell_of_sphere_.size() == n);
    std::fill(start_.begin(), start_.end(), 0U);
    far_ = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        std::uint32_t cell = 0;
        if (find_cell(position[i], cell)) {
            ++start_[cell];
        } else {
            cell = nowhere;
            ++far_;
        }
        cell_of_sphere_[i] = cell;
    }
    near_ = n - far_;
    std::uint32_t sum = 0;
    for (std::uint32_t c = 0; c <= mask_; ++c) {
        sum += start_[c];
        start_[c] = sum;
    }
    start_[mask_ + 1] = near_;

    const std::uint32_t repeats = start_[1];  // entries of cells 0 and 1: start_ still holds the ends
    far_begin_ = near_ + repeats;
    std::uint32_t far = far_begin_ + far_;
    for (std::uint32_t i = n; i-- > 0;) {
        const std::uint32_t cell = cell_of_sphere_[i];
        const std::uint32_t k = cell == nowhere ? --far : --start_[cell];
        const Vec3& p = position[i];
        entry_[k] = {p.x(), p.y(), p.z(), radius[i]};
        id_[k] = static_cast<BodyId>(i);
        if (cell != nowhere) cell_of_entry_[k] = cell;
    }
    std::copy_n(entry_.begin(), repeats, entry_.begin() + near_);
    std::copy_n(id_.begin(), repeats, id_.begin() + near_);
    start_[mask_ + 2] = near_ + start_[1];
    start_[mask_ + 3] = near_ + repeats;
}

}  // namespace carom::stepping
