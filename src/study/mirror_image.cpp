#include "study/mirror_image.hpp"

#include "study/largest.hpp"

#include <carom/metrics.hpp>

#include <algorithm>
#include <limits>

namespace carom::study {

namespace {

Vec3 image(const Vec3& v, const Vec3& normal)
{
    return v - 2 * normal.dot(v) / normal.squaredNorm() * normal;
}

const BodyState& nearest(std::span<const BodyState> states, const Vec3& place)
{
    return *std::min_element(states.begin(), states.end(), [&](const BodyState& a, const BodyState& b) {
        return (a.position - place).squaredNorm() < (b.position - place).squaredNorm();
    });
}

}  // namespace

double mirror_difference(const Scene& scene, std::span<const BodyState> states, const Vec3& normal)
{
    double speed = std::numeric_limits<double>::min();
    for (const Sphere& sphere : scene.spheres) speed = std::max(speed, sphere.velocity.norm());
    double largest = 0;
    for (const BodyState& state : states) {
        const Vec3 place = image(state.position, normal);
        const BodyState& partner = nearest(states, place);
        keep_largest(largest, (partner.position - place).norm() / smallest_radius(scene));
        keep_largest(largest, (partner.velocity - image(state.velocity, normal)).norm() / speed);
    }
    return largest;
}

}  // namespace carom::study
