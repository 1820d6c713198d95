#include "stepping/free_motion.hpp"

namespace carom::stepping {

namespace {

void stop_fixed(Bodies& bodies)
{
    for (const std::size_t i : bodies.fixed) bodies.velocity[i] = Vec3::Zero();
}

/// Gravity for a time, and drag for it on the velocities before.
void change_velocities(Bodies& bodies, const Vec3& gravity, double drag, double time)
{
    if (drag > 0) {
        for (Vec3& v : bodies.velocity) v += time * (gravity - drag * v);
    } else {
        const Vec3 change = time * gravity;
        for (Vec3& v : bodies.velocity) v += change;
    }
    stop_fixed(bodies);
}

void move_straight(Bodies& bodies, double time)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.position[i] += time * bodies.velocity[i];
}

}  // namespace

const DampedTimes& FreeMotion::times_of(double h)
{
    if (h != known_length_) {
        known_length_ = h;
        known_times_ = damped_times(drag_, h);
    }
    return known_times_;
}

double FreeMotion::weight_of_end(double h)
{
    const DampedTimes& times = times_of(h);
    return times.q / (times.s * h);
}

void FreeMotion::fly(Bodies& bodies, double h)
{
    if (integrator_ == Integrator::parabola) {
        if (track_.is_wanted()) {
            accelerate(bodies, h);
            remember(bodies, h, false);
            bodies.velocity = start_;
        }
        const DampedTimes times = times_of(h);
        move_straight(bodies, times.s);
        const Vec3 bend = times.q * gravity_;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            if (bodies.inverse_mass[i] > 0) bodies.position[i] += bend;
        change_velocities(bodies, gravity_, drag_, times.s);
    } else {
        accelerate(bodies, h);
        move_pushed(bodies, h);
    }
}

void FreeMotion::accelerate(Bodies& bodies, double h)
{
    const bool is_exact = integrator_ == Integrator::parabola;
    const bool keeps = is_exact || track_.is_wanted();
    if (keeps) start_ = bodies.velocity;
    change_velocities(bodies, gravity_, drag_, is_exact ? times_of(h).s : h);
    if (keeps) free_ = bodies.velocity;
}

void FreeMotion::move_pushed(Bodies& bodies, double h)
{
    if (track_.is_wanted()) remember(bodies, h, false);
    if (integrator_ == Integrator::euler) return move_straight(bodies, h);
    const double w = weight_of_end(h);
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies.position[i] += h * mean_velocity(bodies, i, w);
}

void FreeMotion::move_struck(Bodies& bodies, double h)
{
    if (track_.is_wanted()) remember(bodies, h, true);
    if (integrator_ == Integrator::euler) return move_straight(bodies, h);
    const double w = weight_of_end(h);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec3& v = bodies.velocity[i];
        bodies.position[i] += h * (v == free_[i] ? mean_velocity(bodies, i, w) : v);
    }
}

Vec3 FreeMotion::mean_velocity(const Bodies& bodies, std::size_t i, double w) const
{
    return (1 - w) * start_[i] + w * bodies.velocity[i];
}

void FreeMotion::resist(Bodies& bodies, double time)
{
    lost_.clear();
    if (!(drag_ > 0)) return;
    for (Vec3& v : bodies.velocity) {
        lost_.push_back((time * drag_) * v);
        v -= lost_.back();
    }
}

double FreeMotion::resist_before(Bodies& bodies, double h)
{
    // The time for which gravity and drag act on the velocities at the begin to make them the mean ones.
    const double time = integrator_ == Integrator::euler ? h : times_of(h).s * weight_of_end(h);
    resist(bodies, time);
    return time;
}

double FreeMotion::resist_after(Bodies& bodies, double h)
{
    if (integrator_ == Integrator::euler) return 0;
    // The same from the mean velocities to those at the end.
    const double time = h * (1 - weight_of_end(h));
    resist(bodies, time);
    return time;
}

void FreeMotion::fall_before(Bodies& bodies, double time)
{
    if (track_.is_wanted()) {
        start_ = bodies.velocity;
        for (std::size_t i = 0; i < lost_.size(); ++i) start_[i] += lost_[i];
    }
    change_velocities(bodies, gravity_, 0, time);
    if (track_.is_wanted()) free_ = bodies.velocity;
}

void FreeMotion::fall_after(Bodies& bodies, double time) const
{
    if (time > 0) change_velocities(bodies, gravity_, 0, time);
}

void FreeMotion::kick_before(Bodies& bodies, double h)
{
    fall_before(bodies, resist_before(bodies, h));
}

void FreeMotion::drift(Bodies& bodies, double h)
{
    if (track_.is_wanted()) remember_drift(bodies);
    move_straight(bodies, h);
}

void FreeMotion::kick_after(Bodies& bodies, double h)
{
    fall_after(bodies, resist_after(bodies, h));
}

void FreeMotion::remember_drift(const Bodies& bodies)
{
    const bool is_bent = integrator_ == Integrator::parabola;
    track_.clear(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const bool is_free = bodies.velocity[i] == free_[i] && bodies.inverse_mass[i] > 0;
        Leg leg;
        leg.position = bodies.position[i];
        leg.velocity = start_[i];  // a rebound is at the end of the substep
        leg.acceleration = is_free ? gravity_ : Vec3(Vec3::Zero());
        leg.slope = is_bent && is_free ? leg.velocity : bodies.velocity[i];
        leg.bend = is_bent ? leg.acceleration : Vec3(Vec3::Zero());
        if (is_free && is_bent) leg.drag = drag_;
        if (is_free && !is_bent && drag_ > 0) leg.acceleration -= drag_ * start_[i];
        track_.begin(i, leg);
    }
}

void FreeMotion::remember(const Bodies& bodies, double h, bool struck)
{
    const bool is_bent = integrator_ == Integrator::parabola;
    const double time = is_bent ? times_of(h).s : h;
    track_.clear(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Vec3& end = bodies.velocity[i];
        // Impulses at the begin of the substep leave one velocity for all of it; those of `move_struck` let a gap
        // close, and the rebound is to come.
        const bool is_even = end != free_[i] && (struck || integrator_ == Integrator::euler);
        Leg leg;
        leg.position = bodies.position[i];
        leg.velocity = is_even && !struck ? end : start_[i];
        leg.acceleration = is_even ? Vec3(Vec3::Zero()) : Vec3((end - start_[i]) / time);
        if (is_bent && !is_even && drag_ > 0) {
            leg.drag = drag_;
            leg.acceleration += drag_ * start_[i];
        }
        leg.slope = is_bent && !is_even ? start_[i] : end;
        leg.bend = is_bent ? leg.acceleration : Vec3(Vec3::Zero());
        track_.begin(i, leg);
    }
}

}  // namespace carom::stepping
