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
    is_bent_ = motion.integrator() == Integrator::parabola;
    SubstepTrack& track = motion.track();
    if (track.is_wanted()) track.clear(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        since_[i] = 0;
        if (!is_bent_) bodies.velocity[i] += length * acceleration[i];
        const auto id = static_cast<BodyId>(i);
        target[i] = place(bodies, id, length);
        if (track.is_wanted()) track.begin(i, leg(bodies, id));
    }
}

void StepPaths::end(Bodies& bodies)
{
    bodies.position.swap(target);
    if (!is_bent_) return;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        bodies.velocity[i] = velocity(bodies, static_cast<BodyId>(i), length_);
}

Leg StepPaths::leg(const Bodies& bodies, BodyId i) const
{
    Leg leg;
    leg.begin = since_[index(i)];
    leg.position = bodies.position[index(i)];
    leg.slope = bodies.velocity[index(i)];
    leg.bend = bend(i);
    leg.acceleration = acceleration[index(i)];
    // With Integrator::euler the velocity of the leg is that at the end of the substep.
    leg.velocity = is_bent_ ? leg.slope : Vec3(leg.slope - (length_ - leg.begin) * leg.acceleration);
    return leg;
}

}  // namespace carom::stepping
