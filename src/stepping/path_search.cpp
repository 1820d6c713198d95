#include "stepping/path_search.hpp"

#include "stepping/hierarchical_grid.hpp"
#include "stepping/tolerances.hpp"

#include <carom/features.hpp>

#include <algorithm>
#include <cmath>

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
        test_near(bodies, detector, reach);
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

void PathSearch::test_near(const Bodies& bodies, Detector& detector, const Reach& reach)
{
    reach_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
        reach_[i] = bodies.radius[i] + margin_of(bodies.radius[i]) + reach.bend +
                    reach.time * std::sqrt(bodies.velocity[i].squaredNorm());
    HierarchicalGrid grid(reach_);  // as the speeds are now: hardly any sphere keeps its cell size for long
    grid.build(bodies.position, reach_);
    grid.for_each_overlap([&](BodyId i, BodyId j) {
        test(bodies, detector, reach, static_cast<std::size_t>(i), static_cast<std::size_t>(j));
    });
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
