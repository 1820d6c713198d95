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
        move_straight(bodies, h);
        const Vec3 bend = (h * h / 2) * gravity_;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (bodies.inverse_mass[i] > 0) bodies.position[i] += bend;
        change_velocities(bodies, gravity_, h);
    } else {
        change_velocities(bodies, gravity_, h);
        move_straight(bodies, h);
    }
}

void FreeMotion::accelerate(Bodies& bodies, double h)
{
    if (integrator_ == Integrator::parabola) start_ = bodies.velocity;
    change_velocities(bodies, gravity_, h);
    if (integrator_ == Integrator::parabola) free_ = bodies.velocity;
}

void FreeMotion::move_pushed(Bodies& bodies, double h) const
{
    if (integrator_ == Integrator::euler) return move_straight(bodies, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.position[i] += (h / 2) * (start_[i] + bodies.velocity[i]);
}

void FreeMotion::move_struck(Bodies& bodies, double h) const
{
    if (integrator_ == Integrator::euler) return move_straight(bodies, h);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec3& v = bodies.velocity[i];
        bodies.position[i] += v == free_[i] ? Vec3((h / 2) * (start_[i] + v)) : Vec3(h * v);
    }
}

void FreeMotion::kick_before(Bodies& bodies, double h) const
{
    change_velocities(bodies, gravity_, integrator_ == Integrator::euler ? h : h / 2);
}

void FreeMotion::drift(Bodies& bodies, double h) const
{
    move_straight(bodies, h);
}

void FreeMotion::kick_after(Bodies& bodies, double h) const
{
    if (integrator_ == Integrator::parabola) change_velocities(bodies, gravity_, h / 2);
}

}  // namespace carom::stepping
