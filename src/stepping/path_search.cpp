#include "stepping/path_search.hpp"

#include "stepping/tolerances.hpp"

#include <carom/features.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::stepping {

namespace {

/// Smallest distance of two points within `time`, squared, for their relative place and velocity.
double least_distance_squared(const Vec3& place, const Vec3& velocity, double time)
{
    const double closing = -place.dot(velocity);
    if (!(closing > 0)) return place.squaredNorm();
    const double nearest = std::min(time, closing / velocity.squaredNorm());
    return (place + nearest * velocity).squaredNorm();
}

double margin_of(double smaller_radius)
{
    return speculative_margin * smaller_radius;
}

}  // namespace

PathSearch::PathSearch(std::size_t spheres) : tests_all_pairs_(automatic_broad_phase(spheres) == BroadPhase::all_pairs)
{
}

void PathSearch::find(const Bodies& bodies, Detector& detector, const Reach& reach, std::vector<Contact>& contacts)
{
    find_pairs(bodies, detector, reach, contacts);
    find_walls(bodies, detector, reach, contacts);
}

void PathSearch::find_pairs(const Bodies& bodies, Detector& detector, const Reach& reach,
                            std::vector<Contact>& contacts)
{
    found_.clear();
    if (tests_all_pairs_) {
        for (std::size_t i = 0; i < bodies.size(); ++i)
            for (std::size_t j = i + 1; j < bodies.size(); ++j) test(bodies, detector, reach, i, j);
    } else {
        sweep(bodies, detector, reach);
        std::sort(found_.begin(), found_.end());
    }
    for (const std::uint64_t pair : found_) {
        const std::size_t a = pair >> 32, b = pair & 0xffffffff;
        const Gap gap = sphere_gap(bodies.position[a], bodies.position[b], bodies.radius[a] + bodies.radius[b]);
        contacts.push_back({gap.value, static_cast<BodyId>(a), static_cast<BodyId>(b), gap.normal});
    }
}

void PathSearch::test(const Bodies& bodies, Detector& detector, const Reach& reach, std::size_t i, std::size_t j)
{
    ++detector.tests;
    if (detector.is_fixed(i) && detector.is_fixed(j)) return;
    const bool one_is_fixed = detector.is_fixed(i) || detector.is_fixed(j);
    const double near = bodies.radius[i] + bodies.radius[j] + margin_of(std::min(bodies.radius[i], bodies.radius[j])) +
                        (one_is_fixed ? reach.bend : 0);
    const double squared = least_distance_squared(bodies.position[i] - bodies.position[j],
                                                  bodies.velocity[i] - bodies.velocity[j], reach.time);
    if (squared <= near * near) found_.push_back(std::uint64_t{std::min(i, j)} << 32 | std::max(i, j));
}

void PathSearch::sweep(const Bodies& bodies, Detector& detector, const Reach& reach)
{
    const std::size_t n = bodies.size();
    box_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 start = bodies.position[i], end = start + reach.time * bodies.velocity[i];
        const Vec3 around = Vec3::Constant(bodies.radius[i] + margin_of(bodies.radius[i]) + reach.bend);
        box_[i] = {start.cwiseMin(end) - around, start.cwiseMax(end) + around};
        // What is no number cannot be sorted; it meets nobody.
        if (!box_[i].low.allFinite() || !box_[i].high.allFinite())
            box_[i] = {Vec3::Constant(std::numeric_limits<double>::infinity()), box_[i].high};
    }
    if (order_.size() != n) {
        order_.resize(n);
        for (std::uint32_t i = 0; i < n; ++i) order_[i] = i;
    }
    std::sort(order_.begin(), order_.end(),
              [this](std::uint32_t i, std::uint32_t j) { return box_[i].low.x() < box_[j].low.x(); });
    for (std::size_t k = 0; k < n; ++k) {
        const Box& box = box_[order_[k]];
        for (std::size_t m = k + 1; m < n && box_[order_[m]].low.x() <= box.high.x(); ++m) {
            const Box& other = box_[order_[m]];
            if (other.low.y() <= box.high.y() && box.low.y() <= other.high.y() && other.low.z() <= box.high.z() &&
                box.low.z() <= other.high.z())
                test(bodies, detector, reach, order_[k], order_[m]);
        }
    }
}

void PathSearch::find_walls(const Bodies& bodies, Detector& detector, const Reach& reach,
                            std::vector<Contact>& contacts)
{
    const std::size_t walls = detector.walls();
    detector.tests += static_cast<std::int64_t>(walls * bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        if (detector.is_fixed(i)) continue;
        const double radius = bodies.radius[i];
        for (std::size_t w = 0; w < walls; ++w) {
            const auto id = static_cast<BodyId>(bodies.size() + w);
            const Gap gap = wall_gap(detector.wall(id), bodies.position[i], radius);
            const double approach = -reach.time * bodies.velocity[i].dot(gap.normal);
            if (gap.value - std::max(approach, 0.0) <= margin_of(radius) + reach.bend)
                contacts.push_back({gap.value, static_cast<BodyId>(i), id, gap.normal});
        }
    }
}

}  // namespace carom::stepping
