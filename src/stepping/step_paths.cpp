#include "stepping/step_paths.hpp"

namespace carom::stepping {

void StepPaths::fall(const Bodies& bodies, const FreeMotion& motion)
{
    for (std::size_t i = 0; i < bodies.size(); ++i)
        acceleration[i] = bodies.inverse_mass[i] > 0 ? motion.gravity() : Vec3(Vec3::Zero());
}

void StepPaths::begin(Bodies& bodies, FreeMotion& motion, double length)
{
    length_ = length;
    drag_ = motion.drag();
    is_bent_ = motion.integrator() == Integrator::parabola;
    SubstepTrack& track = motion.track();
    if (track.is_wanted()) track.clear(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        since_[i] = 0;
        const Vec3 before = bodies.velocity[i];
        if (!is_bent_) bodies.velocity[i] += length * rate(i, before);
        const auto id = static_cast<BodyId>(i);
        target[i] = place(bodies, id, length);
        if (track.is_wanted()) track.begin(i, leg(bodies, id, before));
    }
}

void StepPaths::end(Bodies& bodies)
{
    bodies.position.swap(target);
    if (!is_bent_) return;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        bodies.velocity[i] = velocity(bodies, static_cast<BodyId>(i), length_);
}

Vec3 StepPaths::rate(std::size_t i, const Vec3& velocity) const
{
    return drag_ > 0 ? Vec3(acceleration[i] - drag_ * velocity) : acceleration[i];
}

Leg StepPaths::leg(const Bodies& bodies, BodyId i, const Vec3& before) const
{
    Leg leg;
    leg.begin = since_[index(i)];
    leg.position = bodies.position[index(i)];
    leg.slope = bodies.velocity[index(i)];
    leg.bend = bend(i);
    leg.acceleration = is_bent_ ? acceleration[index(i)] : rate(index(i), before);
    if (is_bent_) leg.drag = drag_;
    // With Integrator::euler the velocity of the leg is that at the end of the substep.
    leg.velocity = is_bent_ ? leg.slope : Vec3(leg.slope - (length_ - leg.begin) * leg.acceleration);
    return leg;
}

}  // namespace carom::stepping
