#include <carom/metrics.hpp>

#include "core/expect.hpp"
#include "study/compensated_sum.hpp"
#include "study/largest.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

using study::CompensatedSum;

std::vector<BodyState> initial_states(const Scene& scene)
{
    std::vector<BodyState> states(scene.spheres.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
        states[i].position = scene.spheres[i].position;
        states[i].velocity = scene.spheres[i].velocity;
        if (scene.spheres[i].fixed) states[i].mode = Mode::fixed;
    }
    return states;
}

double kinetic_energy(const Scene& scene, std::span<const BodyState> states)
{
    CAROM_EXPECT(states.size() == scene.spheres.size());
    CompensatedSum sum;
    for (std::size_t i = 0; i < states.size(); ++i)
        sum.add(scene.spheres[i].mass * states[i].velocity.squaredNorm() / 2);
    return sum.value();
}

double total_energy(const Scene& scene, std::span<const BodyState> states)
{
    CAROM_EXPECT(states.size() == scene.spheres.size());
    CompensatedSum sum;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (scene.spheres[i].fixed) continue;
        const double mass = scene.spheres[i].mass;
        sum.add(mass * states[i].velocity.squaredNorm() / 2);
        sum.add(-mass * scene.gravity.dot(states[i].position));
    }
    return sum.value();
}

double energy_difference(const Scene& scene, std::span<const BodyState> a, std::span<const BodyState> b)
{
    CAROM_EXPECT(a.size() == scene.spheres.size() && b.size() == a.size());
    CompensatedSum sum;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (scene.spheres[i].fixed) continue;
        const Vec3 dv = a[i].velocity - b[i].velocity;
        const Vec3 dx = a[i].position - b[i].position;
        sum.add(scene.spheres[i].mass * dv.dot(a[i].velocity + b[i].velocity) / 2);
        sum.add(-scene.spheres[i].mass * scene.gravity.dot(dx));
    }
    return sum.value();
}

Vec3 momentum(const Scene& scene, std::span<const BodyState> states)
{
    CAROM_EXPECT(states.size() == scene.spheres.size());
    CompensatedSum sums[3];
    for (std::size_t i = 0; i < states.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) sums[axis].add(scene.spheres[i].mass * states[i].velocity[axis]);
    return {sums[0].value(), sums[1].value(), sums[2].value()};
}

std::int64_t escaped(const Scene& scene, std::span<const BodyState> states)
{
    const auto outside = [&](const BodyState& state) {
        if (state.mode == Mode::fixed) return false;
        if (!state.position.allFinite()) return true;
        return std::any_of(scene.planes.begin(), scene.planes.end(), [&](const Plane& plane) {
            return !plane.thickness && plane.normal.dot(state.position) < plane.offset;
        });
    };
    return std::count_if(states.begin(), states.end(), outside);
}

namespace {

template <typename Difference>
Deviation deviation(std::size_t n, Difference difference)
{
    if (n == 0) return {};
    CompensatedSum sum;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double squared = difference(i).squaredNorm();
        sum.add(squared);
        study::keep_largest(largest, squared);
    }
    return {std::sqrt(sum.value() / static_cast<double>(n)), std::sqrt(largest)};
}

}  // namespace

Deviation position_deviation(std::span<const BodyState> a, std::span<const BodyState> b)
{
    CAROM_EXPECT(a.size() == b.size());
    return deviation(a.size(), [&](std::size_t i) -> Vec3 { return a[i].position - b[i].position; });
}

Deviation velocity_deviation(std::span<const BodyState> a, std::span<const BodyState> b)
{
    CAROM_EXPECT(a.size() == b.size());
    return deviation(a.size(), [&](std::size_t i) -> Vec3 { return a[i].velocity - b[i].velocity; });
}

bool contacts_conserve_energy(const Scene& scene)
{
    struct Presence {
        std::size_t movable = 0, fixed = 0;  ///< spheres of a material
    };
    std::vector<Presence> present(scene.materials.size());
    for (const Sphere& sphere : scene.spheres) {
        Presence& material = present[static_cast<std::size_t>(sphere.material)];
        ++(sphere.fixed ? material.fixed : material.movable);
    }
    const auto keeps = [](const ContactLaw& law) {
        return law.restitution == 1 && law.tangential == 1 && law.attenuation == 1;
    };
    const auto can_meet = [&](int a, int b) {
        const Presence &x = present[static_cast<std::size_t>(a)], &y = present[static_cast<std::size_t>(b)];
        if (a == b) return x.movable > 0 && x.movable + x.fixed > 1;
        return (x.movable > 0 && y.movable + y.fixed > 0) || (x.fixed > 0 && y.movable > 0);
    };
    const auto materials = static_cast<int>(scene.materials.size());
    for (int a = 0; a < materials; ++a) {
        if (present[static_cast<std::size_t>(a)].movable > 0)
            for (const Plane& plane : scene.planes)
                if (!keeps(plane_contact_law(scene, a, plane.material))) return false;
        for (int b = a; b < materials; ++b)
            if (can_meet(a, b) && !keeps(sphere_contact_law(scene, a, b))) return false;
    }
    return true;
}

bool conserves_energy(const Scene& scene)
{
    return scene.drag == 0 && contacts_conserve_energy(scene);
}

double smallest_radius(const Scene& scene)
{
    double radius = scene.spheres.empty() ? 0 : scene.spheres.front().radius;
    for (const Sphere& sphere : scene.spheres) radius = std::min(radius, sphere.radius);
    return radius;
}

}  // namespace carom
