#include "scene/sphere_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
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
    if (!(coordinate > -farthest_cell_number)) return static_cast<std::int64_t>(-farthest_cell_number);
    if (!(coordinate < farthest_cell_number)) return static_cast<std::int64_t>(farthest_cell_number);
    const auto truncated = static_cast<std::int64_t>(coordinate);  // (without SSE 4.1 std::floor is a call)
    return truncated - (static_cast<double>(truncated) > coordinate ? 1 : 0);
}

/// 1 / edge: cells are as wide as the largest sphere, or wider where a double has no such number [1/length].
double cells_per_length(double radius)
{
    return std::min(0.5 / radius, most_cells_per_length);
}

}  // namespace

std::vector<std::size_t> largest_first(const std::vector<double>& radii)
{
    std::vector<std::size_t> order(radii.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (std::is_sorted(radii.begin(), radii.end(), std::greater<>())) return order;  // as where all are of one size
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return radii[i] > radii[j]; });
    return order;
}

double SphereGrid::cells_between(const Cell& low, const Cell& high)
{
    double n = 1;
    for (std::size_t i = 0; i < low.size(); ++i) n *= static_cast<double>(high[i] - low[i] + 1);
    return n;
}

SphereGrid::Cell SphereGrid::cell_of(const Level& level, const Vec3& position)
{
    const double k = level.per_cell;
    return {cell_number(k * position.x()), cell_number(k * position.y()), cell_number(k * position.z())};
}

SphereGrid::SphereGrid(const std::vector<double>& radii)
{
    std::vector<std::size_t> members;  // of each level
    for (const double radius : radii) {
        Level& level = level_of(radius);
        level.radius = std::max(level.radius, radius);
        level.per_cell = cells_per_length(level.radius);
        members.resize(levels_.size());
        ++members[static_cast<std::size_t>(&level - levels_.data())];
    }
    for (std::size_t l = 0; l < levels_.size(); ++l) {
        levels_[l].entries.reserve(members[l]);
        levels_[l].newest.assign(std::max(fewest_buckets, std::bit_ceil(2 * members[l])), none);
    }
}

SphereGrid::Level& SphereGrid::level_of(double radius)
{
    const int exponent = binary_exponent(radius);
    const auto level =
        std::find_if(levels_.begin(), levels_.end(), [&](const Level& l) { return l.exponent == exponent; });
    if (level != levels_.end()) return *level;
    std::vector<Index> newest(fewest_buckets, none);
    return levels_.emplace_back(Level{exponent, radius, cells_per_length(radius), {}, std::move(newest)});
}

void SphereGrid::insert(std::size_t sphere, const Vec3& position, double radius)
{
    Level& level = level_of(radius);
    CAROM_EXPECT(radius <= level.radius);
    if (2 * level.entries.size() > level.newest.size()) grow(level);
    const Cell cell = cell_of(level, position);
    Index& newest = level.newest[bucket(level, cell)];
    level.entries.push_back({sphere, cell, newest});
    newest = static_cast<Index>(level.entries.size() - 1);
}

void SphereGrid::move(std::size_t sphere, const Vec3& from, const Vec3& to, double radius)
{
    Level& level = level_of(radius);
    const Cell old_cell = cell_of(level, from), cell = cell_of(level, to);
    if (same(old_cell, cell)) return;
    Index* link = &level.newest[bucket(level, old_cell)];
    while (level.entries[*link].sphere != sphere) {
        link = &level.entries[*link].older;
        CAROM_EXPECT(*link != none);
    }
    const Index e = *link;
    *link = level.entries[e].older;
    Index& newest = level.newest[bucket(level, cell)];
    level.entries[e] = {sphere, cell, newest};
    newest = e;
}

void SphereGrid::grow(Level& level)
{
    level.newest.assign(2 * level.newest.size(), none);
    for (std::size_t e = 0; e < level.entries.size(); ++e) {
        Index& newest = level.newest[bucket(level, level.entries[e].cell)];
        level.entries[e].older = newest;
        newest = static_cast<Index>(e);
    }
}

void SphereGrid::clear()
{
    for (Level& level : levels_) {
        for (const Entry& entry : level.entries) level.newest[bucket(level, entry.cell)] = none;
        level.entries.clear();
    }
}

}  // namespace carom
