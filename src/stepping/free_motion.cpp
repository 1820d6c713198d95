#include "stepping/free_motion.hpp"

namespace carom::stepping {

namespace {

void change_velocities(Bodies& bodies, const Vec3& gravity, double h)
{
    const Vec3 change = h * gravity;
    for (Vec3& v : bodies.velocity) v += change;
    for (const std::size_t i : bodies.fixed) bodies.velocity[i] = Vec3::Zero();
}

void move_straight(Bodies& bodies, double h)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.position[i] += h * bodies.velocity[i];
}

}  // namespace

void FreeMotion::fly(Bodies& bodies, double h)
{
    if (integrator_ == Integrator::parabola) {
        if (track_.is_wanted()) {
            accelerate(bodies, h);
            remember(bodies, h, false);
            bodies.velocity = start_;
        }
        move_straight(bodies, h);
        const Vec3 bend = (h * h / 2) * gravity_;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (bodies.inverse_mass[i] > 0) bodies.position[i] += bend;
        change_velocities(bodies, gravity_, h);
    } else {
        accelerate(bodies, h);
        move_pushed(bodies, h);
    }
}

void FreeMotion::accelerate(Bodies& bodies, double h)
{
    const bool keeps = integrator_ == Integrator::parabola || track_.is_wanted();
    if (keeps) start_ = bodies.velocity;
    change_velocities(bodies, gravity_, h);
    if (keeps) free_ = bodies.velocity;
}

void FreeMotion::move_pushed(Bodies& bodies, double h)
{
    if (track_.is_wanted()) remember(bodies, h, false);
    if (integrator_ == Integrator::euler) return move_straight(bodies, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.position[i] += (h / 2) * (start_[i] + bodies.velocity[i]);
}

void FreeMotion::move_struck(Bodies& bodies, double h)
{
    if (track_.is_wanted()) remember(bodies, h, true);
    if (integrator_ == Integrator::euler) return move_straight(bodies, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec3& v = bodies.velocity[i];
        bodies.position[i] += v == free_[i] ? Vec3((h / 2) * (start_[i] + v)) : Vec3(h * v);
    }
}

void FreeMotion::kick_before(Bodies& bodies, double h)
{
    if (track_.is_wanted()) start_ = bodies.velocity;
    change_velocities(bodies, gravity_, integrator_ == Integrator::euler ? h : h / 2);
    if (track_.is_wanted()) free_ = bodies.velocity;
}

void FreeMotion::drift(Bodies& bodies, double h)
{
    if (track_.is_wanted()) remember_drift(bodies);
    move_straight(bodies, h);
}

void FreeMotion::kick_after(Bodies& bodies, double h) const
{
    if (integrator_ == Integrator::parabola) change_velocities(bodies, gravity_, h / 2);
}

void FreeMotion::remember_drift(const Bodies& bodies)
{
    track_.clear(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const bool is_free = bodies.velocity[i] == free_[i] && bodies.inverse_mass[i] > 0;
        Leg leg;
        leg.position = bodies.position[i];
        leg.velocity = start_[i];  // a rebound is at the end of the substep
        leg.acceleration = is_free ? gravity_ : Vec3(Vec3::Zero());
        const bool is_bent = integrator_ == Integrator::parabola;
        leg.slope = is_bent && is_free ? leg.velocity : bodies.velocity[i];
        leg.bend = is_bent ? leg.acceleration : Vec3(Vec3::Zero());
        track_.begin(i, leg);
    }
}

void FreeMotion::remember(const Bodies& bodies, double h, bool struck)
{
    track_.clear(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec3& end = bodies.velocity[i];
        // Impulses at the begin of the substep leave one velocity for all of it; those of `move_struck` let a gap
        // close, and the rebound is to come.
        const bool is_even = end != free_[i] && (struck || integrator_ == Integrator::euler);
        Leg leg;
        leg.position = bodies.position[i];
        leg.velocity = is_even && !struck ? end : start_[i];
        leg.acceleration = is_even ? Vec3(Vec3::Zero()) : Vec3((end - start_[i]) / h);
        const bool is_bent = integrator_ == Integrator::parabola;
        leg.slope = is_bent && !is_even ? start_[i] : end;
        leg.bend = is_bent ? leg.acceleration : Vec3(Vec3::Zero());
        track_.begin(i, leg);
    }
}

}  // namespace carom::stepping
