#include "flight/flight.hpp"

#include "flight/tolerances.hpp"
#include "math/length.hpp"

namespace carom {

Accelerations::Accelerations(const Scene& scene) : has_gravity_(!scene.gravity.isZero(0)), table_{Vec3::Zero()}
{
    if (!has_gravity_) return;
    table_.push_back(scene.gravity);
    const double g = length(scene.gravity);
    for (const auto& plane : scene.planes) {
        Vec3 along = scene.gravity - scene.gravity.dot(plane.normal) / plane.normal.squaredNorm() * plane.normal;
        // A level floor must not make what rests on it creep at the rounding of its normal.
        if (length(along) <= level_rounding * g) along = Vec3::Zero();
        table_.push_back(along);
    }
    shared_ = static_cast<AccelerationId>(table_.size());
}

}  // namespace carom
