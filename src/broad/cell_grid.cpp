#include "broad/cell_grid.hpp"

#include "flight/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// The next number with a mantissa of few bits, so that its multiples are exact doubles.
double round_up_to_few_bits(double x)
{
    const double unit = power_of_two_below(x) / cell_size_parts;
    return std::ceil(x / unit) * unit;
}

/// A part of the mean spacing where spheres are sparse, and never smaller than the reach. (Only the cost depends on it,
/// so a libm's cbrt does no harm.)
double choose_cell_size(const Vec3& extent, std::size_t count, double reach)
{
    const double volume = std::max(extent[0], reach) * std::max(extent[1], reach) * std::max(extent[2], reach);
    const double spacing = std::cbrt(volume / static_cast<double>(count));
    return round_up_to_few_bits(std::max(reach, spacings_a_cell * spacing));
}

}  // namespace

CellGrid::CellGrid(const Frame& frame, const std::vector<Place>& places, double reach)
    : cells_(places.size()), next_(places.size(), no_body), prev_(places.size(), no_body)
{
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& place : places) {
        const Vec3 p = position_of(frame, place);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vec3 extent = high - low;
    cell_size_ = choose_cell_size(extent, places.size(), reach);

    // As many cells along each axis as the spheres fill, but no more entries than they deserve.
    std::array<int, 3> bits{};
    for (int k = 0; k < 3; ++k)
        for (bits[k] = least_bits_an_axis;
             bits[k] < most_bits_an_axis && std::ldexp(cell_size_, bits[k]) < extent[k] + cell_size_;)
            ++bits[k];
    const auto most =
        entry_bits_a_sphere + static_cast<int>(std::ceil(std::log2(static_cast<double>(places.size()) + 1)));
    while (bits[0] + bits[1] + bits[2] > std::max(most, 3 * least_bits_an_axis))
        --*std::max_element(bits.begin(), bits.end());
    int shift = 0;
    for (int k = 0; k < 3; ++k) {
        mask_[k] = (std::int64_t{1} << bits[k]) - 1;
        shift_[k] = shift;
        shift += bits[k];
    }
    first_.assign(std::size_t{1} << shift, no_body);

    for (std::size_t i = 0; i < places.size(); ++i) {
        cells_[i] = cell_of(position_of(frame, places[i]));
        file(static_cast<BodyId>(i));
    }
}

Cell CellGrid::cell_of(const Vec3& position) const
{
    Cell cell;
    for (int k = 0; k < 3; ++k)
        cell[k] = static_cast<std::int64_t>(std::floor(std::clamp(position[k] / cell_size_, -furthest, furthest)));
    return cell;
}

void CellGrid::file_at(BodyId body, const Vec3& position)
{
    unfile(body);
    cells_[static_cast<std::size_t>(body)] = cell_of(position);
    file(body);
}

void CellGrid::file(BodyId body)
{
    const auto i = static_cast<std::size_t>(body);
    BodyId& head = first_[entry(cells_[i])];
    next_[i] = head;
    prev_[i] = no_body;
    if (head != no_body) prev_[static_cast<std::size_t>(head)] = body;
    head = body;
}

void CellGrid::unfile(BodyId body)
{
    const auto i = static_cast<std::size_t>(body);
    if (prev_[i] == no_body)
        first_[entry(cells_[i])] = next_[i];
    else
        next_[static_cast<std::size_t>(prev_[i])] = next_[i];
    if (next_[i] != no_body) prev_[static_cast<std::size_t>(next_[i])] = prev_[i];
}

void CellGrid::step(BodyId body, int axis, int direction)
{
    unfile(body);
    cells_[static_cast<std::size_t>(body)][axis] += direction;
    file(body);
}

double CellGrid::above_lower_wall(const Frame& frame, BodyId body, int axis, const Place& place) const
{
    const double wall = static_cast<double>(cell(body)[axis]) * cell_size_;
    return (static_cast<double>(place.cell[axis]) * frame.cell_size - wall) + place.local[axis];
}

double CellGrid::below_upper_wall(const Frame& frame, BodyId body, int axis, const Place& place) const
{
    const double wall = static_cast<double>(cell(body)[axis] + 1) * cell_size_;
    return (wall - static_cast<double>(place.cell[axis]) * frame.cell_size) - place.local[axis];
}

}  // namespace carom
