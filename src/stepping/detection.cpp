#include "stepping/detection.hpp"

#include <carom/features.hpp>

#include <algorithm>

namespace carom::stepping {

Detector::Detector(const Scene& scene, BroadPhase broad_phase) : spheres_(static_cast<BodyId>(scene.spheres.size()))
{
    for (const Plane& p : scene.planes)
        walls_.push_back(
            {p.normal, p.offset + p.normal.dot(scene.origin), p.thickness.value_or(0) / 2, p.thickness.has_value()});
    const std::size_t n = scene.spheres.size();
    for (std::size_t i = 0; i < n; ++i) {
        if (!scene.spheres[i].fixed) continue;
        fixed_.resize(n);
        fixed_[i] = 1;
    }
    if (broad_phase == BroadPhase::automatic) broad_phase = automatic_broad_phase(n);
    if (broad_phase == BroadPhase::cell_grid && n > 0) {
        std::vector<double> radius;
        radius.reserve(n);
        for (const Sphere& s : scene.spheres) radius.push_back(s.radius);
        grid_.emplace(radius);
    }
}

void Detector::find_pairs(const std::vector<Vec3>& position, const std::vector<double>& radius,
                          std::vector<Contact>& contacts)
{
    found_.clear();
    if (grid_) {
        grid_->build(position, radius);
        tests += grid_->for_each_overlap([this](BodyId i, BodyId j) {
            const auto a = static_cast<std::uint64_t>(std::min(i, j));
            const auto b = static_cast<std::uint64_t>(std::max(i, j));
            found_.push_back(a << 32 | b);
        });
        std::sort(found_.begin(), found_.end());
    } else {
        const std::size_t n = position.size();
        for (std::size_t a = 0; a < n; ++a) {
            for (std::size_t b = a + 1; b < n; ++b) {
                const Vec3 d = position[a] - position[b];
                if (overlap(d.x(), d.y(), d.z(), radius[a] + radius[b])) found_.push_back(std::uint64_t{a} << 32 | b);
            }
        }
        tests += static_cast<std::int64_t>(n * (n - (n > 0)) / 2);
    }
    for (const std::uint64_t pair : found_) {
        const std::size_t a = pair >> 32, b = pair & 0xffffffff;
        if (is_fixed(a) && is_fixed(b)) continue;
        const Gap gap = sphere_gap(position[a], position[b], radius[a] + radius[b]);
        contacts.push_back({gap.value, static_cast<BodyId>(a), static_cast<BodyId>(b), gap.normal});
    }
}

void Detector::find_walls_of(BodyId sphere, const Vec3& position, double radius, std::vector<Contact>& contacts)
{
    if (is_fixed(static_cast<std::size_t>(sphere))) return;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        if (!overlap(walls_[w], position, radius)) continue;
        const Gap gap = wall_gap(walls_[w], position, radius);
        contacts.push_back({gap.value, sphere, spheres_ + static_cast<BodyId>(w), gap.normal});
    }
    tests += static_cast<std::int64_t>(walls_.size());
}

void Detector::find_walls(const std::vector<Vec3>& position, const std::vector<double>& radius,
                          std::vector<Contact>& contacts)
{
    found_.clear();
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        const Wall wall = walls_[w];  // a copy stays in registers
        for (std::size_t i = 0; i < position.size(); ++i)
            if (overlap(wall, position[i], radius[i])) found_.push_back(std::uint64_t{i} << 32 | w);
    }
    tests += static_cast<std::int64_t>(walls_.size() * position.size());
    std::sort(found_.begin(), found_.end());
    for (const std::uint64_t found : found_) {
        const std::size_t i = found >> 32, w = found & 0xffffffff;
        if (is_fixed(i)) continue;
        const Gap gap = wall_gap(walls_[w], position[i], radius[i]);
        contacts.push_back({gap.value, static_cast<BodyId>(i), spheres_ + static_cast<BodyId>(w), gap.normal});
    }
}

double deepest_penetration(const std::vector<Contact>& contacts)
{
    double deepest = 0;
    for (const Contact& c : contacts) deepest = std::max(deepest, -c.gap);
    return deepest;
}

}  // namespace carom::stepping
