#include <carom/metrics.hpp>

#include "core/expect.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

struct Interval {
    double low, high;  // of the sphere on the sweep axis
    std::size_t sphere;
};

int widest_axis(std::span<const BodyState> states, std::span<const Interval> finite)
{
    Vec3 low = states[finite.front().sphere].position, high = low;
    for (const Interval& each : finite) {
        low = low.cwiseMin(states[each.sphere].position);
        high = high.cwiseMax(states[each.sphere].position);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    return axis;
}

}  // namespace

double max_penetration(const Scene& scene, std::span<const BodyState> states)
{
    CAROM_EXPECT(states.size() == scene.spheres.size());
    const auto can_move = [&](std::size_t a, std::size_t b) {
        return !scene.spheres[a].fixed || !scene.spheres[b].fixed;
    };
    std::vector<Interval> intervals;
    intervals.reserve(states.size());
    double deepest = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const Vec3& position = states[i].position;
        if (!position.allFinite()) continue;
        intervals.push_back({0, 0, i});
        if (scene.spheres[i].fixed) continue;
        for (const Plane& plane : scene.planes)
            deepest = std::max(deepest, -plane_gap(plane, scene.spheres[i], position));
    }
    if (intervals.empty()) return deepest;

    const int axis = widest_axis(states, intervals);
    for (Interval& each : intervals) {
        const double x = states[each.sphere].position[axis], r = scene.spheres[each.sphere].radius;
        each.low = x - r;
        each.high = x + r;
    }
    std::sort(intervals.begin(), intervals.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
    for (std::size_t i = 0; i < intervals.size(); ++i)
        for (std::size_t j = i + 1; j < intervals.size() && intervals[j].low <= intervals[i].high; ++j) {
            const std::size_t a = intervals[i].sphere, b = intervals[j].sphere;
            const double reach = scene.spheres[a].radius + scene.spheres[b].radius;
            const double squared = (states[a].position - states[b].position).squaredNorm();
            if (squared < reach * reach && can_move(a, b)) deepest = std::max(deepest, reach - std::sqrt(squared));
        }
    return deepest;
}

}  // namespace carom
