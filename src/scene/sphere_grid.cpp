#include "scene/sphere_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "core/expect.hpp"
#include "scene/tolerances.hpp"

namespace carom {

namespace {

int binary_exponent(double x)
{
    constexpr int mantissa_bits = 52, exponent_mask = 0x7ff;
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> mantissa_bits) & exponent_mask;
}

std::int64_t cell_number(double coordinate)
{
    return static_cast<std::int64_t>(std::clamp(std::floor(coordinate), -farthest_cell_number, farthest_cell_number));
}

}  // namespace

std::vector<std::size_t> largest_first(const std::vector<double>& radii)
{
    std::vector<std::size_t> order(radii.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return radii[i] > radii[j]; });
    return order;
}

std::size_t SphereGrid::CellHash::operator()(const Cell& cell) const
{
    std::uint64_t h = 0;
    for (const std::int64_t c : cell) {
        h = (h ^ static_cast<std::uint64_t>(c)) * 0x9e3779b97f4a7c15ULL;
        h ^= h >> 29;
    }
    return static_cast<std::size_t>(h);
}

double SphereGrid::cells_between(const Cell& low, const Cell& high)
{
    double n = 1;
    for (std::size_t i = 0; i < low.size(); ++i) n *= static_cast<double>(high[i] - low[i] + 1);
    return n;
}

SphereGrid::Cell SphereGrid::cell_of(const Vec3& position, double radius)
{
    const Vec3 scaled = position / radius / 2;
    return {cell_number(scaled.x()), cell_number(scaled.y()), cell_number(scaled.z())};
}

void SphereGrid::insert(std::size_t sphere, const Vec3& position, double radius)
{
    const int exponent = binary_exponent(radius);
    auto level = std::find_if(levels_.begin(), levels_.end(), [&](const Level& l) { return l.exponent == exponent; });
    if (level == levels_.end()) level = levels_.insert(levels_.end(), Level{exponent, radius, {}});
    CAROM_EXPECT(radius <= level->radius);
    const auto [place, first] = level->newest.try_emplace(cell_of(position, level->radius), entries_.size());
    entries_.push_back({sphere, first ? none : place->second});
    place->second = entries_.size() - 1;
}

}  // namespace carom
