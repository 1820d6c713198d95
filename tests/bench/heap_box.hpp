/// \file
/// Balls in one open box, and lists of those that are near each other: what a driver of windows needs around them.
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

/// Buckets of the balls' centres in a square box of a side, of any height.
class Buckets {
public:
    Buckets(const std::vector<WindowBody>& balls, double side, double least)
        : across_(std::max(1, static_cast<int>(side / least))), size_(side / across_), high_(least)
    {
        double top = 0;
        for (const WindowBody& ball : balls) top = std::max(top, ball.place.z());
        layers_ = static_cast<int>(top / high_) + 1;
        members_.resize(static_cast<std::size_t>(across_) * static_cast<std::size_t>(across_) *
                        static_cast<std::size_t>(layers_));
        for (std::size_t i = 0; i < balls.size(); ++i)
            members_[index(cell(balls[i].place))].push_back(static_cast<int>(i));
    }

    template <class Visit>
    void near(const Vec3& place, Visit&& visit) const
    {
        const auto [x, y, z] = cell(place);
        for (int i = std::max(0, x - 1); i <= std::min(across_ - 1, x + 1); ++i)
            for (int j = std::max(0, y - 1); j <= std::min(across_ - 1, y + 1); ++j)
                for (int k = std::max(0, z - 1); k <= std::min(layers_ - 1, z + 1); ++k)
                    for (const int ball : members_[index({i, j, k})]) visit(ball);
    }

private:
    using Cell = std::array<int, 3>;
    Cell cell(const Vec3& p) const
    {
        const auto along = [](double x, double size, int count) {
            return std::clamp(static_cast<int>(x / size), 0, count - 1);
        };
        return {along(p.x(), size_, across_), along(p.y(), size_, across_), along(p.z(), high_, layers_)};
    }
    std::size_t index(const Cell& c) const
    {
        return (static_cast<std::size_t>(c[0]) * static_cast<std::size_t>(across_) + static_cast<std::size_t>(c[1])) *
                   static_cast<std::size_t>(layers_) +
               static_cast<std::size_t>(c[2]);
    }

    int across_, layers_ = 1;
    double size_, high_;
    std::vector<std::vector<int>> members_;
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
