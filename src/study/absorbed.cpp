#include "study/absorbed.hpp"

#include "scene/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::study {

namespace {

/// A body just before a time; planes stand still.
TruthState state_of(const Scene& scene, const Truth& run, BodyId body, double time)
{
    return static_cast<std::size_t>(body) < scene.spheres.size() ? run.state_before(body, time) : TruthState{};
}

/// Height of a bounce at v_c, or what counts as touching where nothing falls [length].
double low_height(const Scene& scene, double slow)
{
    const double touching = declared_contact * smallest_radius(scene), gravity = scene.gravity.norm();
    return gravity > 0 ? std::max(touching, slow * slow / (2 * gravity)) : touching;
}

}  // namespace

double gap_rate_before(const Scene& scene, const Truth& run, const Vec3& normal, BodyId a, BodyId b, double time)
{
    return normal.dot(state_of(scene, run, a, time).velocity - state_of(scene, run, b, time).velocity);
}

bool is_absorbed(const Scene& scene, const Truth& run, BodyId a, BodyId b, double time)
{
    if (time > run.until) return false;
    const Sphere& sphere = scene.spheres[static_cast<std::size_t>(a)];
    const Vec3 place = state_of(scene, run, a, time).position;
    const double slow = rest_thresholds(scene).closing_speed;
    double gap = 0;
    Vec3 normal = Vec3::Zero();
    if (static_cast<std::size_t>(b) < scene.spheres.size()) {
        const Vec3 apart = place - state_of(scene, run, b, time).position;
        gap = apart.norm() - sphere.radius - scene.spheres[static_cast<std::size_t>(b)].radius;
        normal = apart.normalized();
    } else {
        const Plane& plane = scene.planes[static_cast<std::size_t>(b) - scene.spheres.size()];
        gap = plane_gap(plane, sphere, place);
        normal = plane.normal;
    }
    return gap <= low_height(scene, slow) && std::abs(gap_rate_before(scene, run, normal, a, b, time)) < slow;
}

}  // namespace carom::study
