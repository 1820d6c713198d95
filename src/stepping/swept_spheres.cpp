#include "stepping/swept_spheres.hpp"

#include "stepping/tolerances.hpp"

#include <carom/features.hpp>

#include <cmath>

namespace carom::stepping {

SweptSpheres::SweptSpheres(const Scene& scene)
    : uses_grid_(automatic_broad_phase(scene.spheres.size()) == BroadPhase::cell_grid),
      centre_(scene.spheres.size()),
      radius_(scene.spheres.size()),
      is_changed_(scene.spheres.size())
{
}

void SweptSpheres::begin(const System& system, const StepPaths& paths)
{
    for (const BodyId i : changed_) is_changed_[static_cast<std::size_t>(i)] = 0;
    changed_.clear();
    for (std::size_t i = 0; i < centre_.size(); ++i) enclose(system, paths, i, 0);
    if (!uses_grid_) return;
    grid_.emplace(radius_);
    grid_->build(centre_, radius_);
}

void SweptSpheres::change(const System& system, const StepPaths& paths, BodyId i, double now)
{
    const auto at = static_cast<std::size_t>(i);
    enclose(system, paths, at, now);
    if (is_changed_[at]) return;
    is_changed_[at] = 1;
    changed_.push_back(i);
}

void SweptSpheres::enclose(const System& system, const StepPaths& paths, std::size_t i, double now)
{
    const auto id = static_cast<BodyId>(i);
    const Vec3 start = paths.place(system.bodies, id, now);
    const Vec3 half = (paths.target[i] - start) / 2;
    // A path leaves its chord by at most |a| (t/2)^2 / 2, a the largest of its accelerations.
    const double half_time = (paths.length() - now) / 2;
    const double sag = std::sqrt(paths.bend_at_begin(system.bodies, id).squaredNorm()) * (half_time * half_time) / 2;
    centre_[i] = start + half;
    radius_[i] = (system.bodies.radius[i] + std::sqrt(half.squaredNorm()) + sag) * (1 + cell_slack);
}

}  // namespace carom::stepping
