#include "study/deepest_overlap.hpp"

#include "core/expect.hpp"

#include <carom/metrics.hpp>

#include <algorithm>

namespace carom {

namespace study {

void DeepestOverlap::Bounds::add(const Vec3& p)
{
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], p[axis]);  // in this order: what is no number changes nothing
        high[axis] = std::max(high[axis], p[axis]);
    }
}

Vec3 DeepestOverlap::Bounds::lowest(const Vec3& normal) const
{
    Vec3 corner;
    for (int axis = 0; axis < 3; ++axis) corner[axis] = normal[axis] > 0 ? low[axis] : high[axis];
    return corner;
}

DeepestOverlap::DeepestOverlap(const Scene& scene) : position_(scene.spheres.size()), detector_(scene)
{
    radius_.reserve(scene.spheres.size());
    for (const Sphere& sphere : scene.spheres) {
        radius_.push_back(sphere.radius);
        largest_radius_ = std::max(largest_radius_, sphere.radius);
    }
    for (const Plane& plane : scene.planes)
        walls_.push_back({plane.normal, plane.offset, plane.thickness.value_or(0) / 2, plane.thickness.has_value()});
}

double DeepestOverlap::of(std::span<const BodyState> states)
{
    CAROM_EXPECT(states.size() == position_.size());
    Bounds bounds;
    for (std::size_t i = 0; i < states.size(); ++i) {
        position_[i] = states[i].position;
        bounds.add(position_[i]);
    }
    overlaps_.clear();
    detector_.find_pairs(position_, radius_, overlaps_);
    return std::max(stepping::deepest_penetration(overlaps_), deepest_in_walls(bounds));
}

double DeepestOverlap::deepest_in_walls(const Bounds& bounds) const
{
    double deepest = 0;
    for (const stepping::Wall& wall : walls_) {
        const Vec3 nearest = bounds.lowest(wall.normal);
        // Nobody computes a smaller height: products and sums of rounded numbers are monotonic.
        if (stepping::wall_height(wall, nearest) > 0 && !stepping::overlap(wall, nearest, largest_radius_)) continue;
        for (std::size_t i = 0; i < position_.size(); ++i) {
            if (!stepping::overlap(wall, position_[i], radius_[i])) continue;
            if (detector_.is_fixed(i) || !position_[i].allFinite()) continue;
            deepest = std::max(deepest, -stepping::wall_gap(wall, position_[i], radius_[i]).value);
        }
    }
    return deepest;
}

}  // namespace study

double max_penetration(const Scene& scene, std::span<const BodyState> states)
{
    return study::DeepestOverlap(scene).of(states);
}

}  // namespace carom
