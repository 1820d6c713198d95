/// \file
/// Balls in one open box.
#pragma once

#include "core/random.hpp"
#include "window/window_problem.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace carom::bench {

inline constexpr double gravity = 9.81;

struct Box {
    std::vector<WindowBody> balls;
    std::vector<WindowPlane> planes;
    double side = 0;
};

/// Radii of 8 to 16 mm, `layers` deep when settled, at first a fifth of the volume, at rest in the air.
inline Box drop(int count, std::uint64_t seed, double layers)
{
    constexpr double smallest = 0.008, largest = 0.016, density = 2500, filled = 0.2;
    constexpr double mean = (smallest + largest) / 2;
    Random random(seed);
    Box box;
    box.side = std::max(4 * largest, std::sqrt(count / layers) * 2 * mean);
    std::vector<double> radii;
    double volume = 0;
    for (int i = 0; i < count; ++i) {
        radii.push_back(random.uniform(smallest, largest));
        volume += 4 * std::numbers::pi / 3 * radii.back() * radii.back() * radii.back();
    }
    const double height = volume / (filled * box.side * box.side) + 2 * largest;
    const double cell = 2 * largest;
    const int across = static_cast<int>(box.side / cell) + 1, up = static_cast<int>(height / cell) + 1;
    std::vector<std::vector<int>> cells(static_cast<std::size_t>(across) * static_cast<std::size_t>(across) *
                                        static_cast<std::size_t>(up));
    const auto index = [&](int x, int y, int z) { return static_cast<std::size_t>((x * across + y) * up + z); };
    std::vector<Vec3> places(radii.size());
    for (std::size_t i = 0; i < radii.size(); ++i) {
        for (;;) {
            const double r = radii[i], x = random.uniform(r, box.side - r), y = random.uniform(r, box.side - r),
                         z = random.uniform(r, height - r);
            const int cx = static_cast<int>(x / cell), cy = static_cast<int>(y / cell), cz = static_cast<int>(z / cell);
            bool clear = true;
            for (int a = std::max(0, cx - 1); a <= std::min(across - 1, cx + 1); ++a)
                for (int b = std::max(0, cy - 1); b <= std::min(across - 1, cy + 1); ++b)
                    for (int c = std::max(0, cz - 1); c <= std::min(up - 1, cz + 1); ++c)
                        for (const int j : cells[index(a, b, c)])
                            clear = clear && (Vec3(x, y, z) - places[static_cast<std::size_t>(j)]).norm() >
                                                 1.0001 * (r + radii[static_cast<std::size_t>(j)]);
            if (!clear) continue;
            places[i] = Vec3(x, y, z);
            cells[index(cx, cy, cz)].push_back(static_cast<int>(i));
            break;
        }
    }
    // Numbers follow the cells, so that neighbours in space are neighbours in memory.
    for (const std::vector<int>& members : cells)
        for (const int i : members) {
            const double r = radii[static_cast<std::size_t>(i)];
            box.balls.push_back({places[static_cast<std::size_t>(i)], Vec3::Zero(), Vec3(0, 0, -gravity),
                                 1 / (density * 4 * std::numbers::pi / 3 * r * r * r), r});
        }
    box.planes = {{Vec3::UnitZ(), 0, {}},
                  {Vec3::UnitX(), 0, {}},
                  {-Vec3::UnitX(), -box.side, {}},
                  {Vec3::UnitY(), 0, {}},
                  {-Vec3::UnitY(), -box.side, {}}};
    return box;
}

}  // namespace carom::bench
