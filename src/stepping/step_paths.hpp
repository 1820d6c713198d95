/// \file
/// The motion of spheres within one substep of a method that finds contacts inside it: straight with
/// Integrator::euler, parabolas with Integrator::parabola, with drag damped flights, with corners where velocities
/// change.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/damped_times.hpp"
#include "stepping/free_motion.hpp"

#include <cstdint>
#include <vector>

namespace carom::stepping {

/// Each sphere carries its own moment `since` of Bodies::position and Bodies::velocity, and the `target` that it
/// reaches at the end.
class StepPaths {
public:
    explicit StepPaths(std::size_t spheres)
        : target(spheres), acceleration(spheres, Vec3::Zero()), since_(spheres), changes_(spheres)
    {
    }

    /// Gravity as the acceleration of all that move.
    void fall(const Bodies& bodies, const FreeMotion& motion);
    /// All from their positions, for a time of `length`, with the accelerations as they are.
    void begin(Bodies& bodies, FreeMotion& motion, double length);
    /// All are where their paths end.
    void end(Bodies& bodies);

    /// \pre time >= since(i).
    Vec3 place(const Bodies& bodies, BodyId i, double time) const
    {
        const double t = time - since_[index(i)];
        const Vec3 &p = bodies.position[index(i)], &v = bodies.velocity[index(i)];
        return is_bent_ ? place_after(damped_times(drag_, t), p, v, acceleration[index(i)]) : Vec3(p + t * v);
    }

    /// \pre time >= since(i).
    Vec3 velocity(const Bodies& bodies, BodyId i, double time) const
    {
        const Vec3& v = bodies.velocity[index(i)];
        if (!is_bent_) return v;
        return velocity_after(damped_times(drag_, time - since_[index(i)]), drag_, v, acceleration[index(i)]);
    }

    /// Rate of change of velocity on the path but for drag: none on a straight one [length/time^2].
    Vec3 bend(BodyId i) const { return is_bent_ ? acceleration[index(i)] : Vec3(Vec3::Zero()); }
    /// All of that rate at the begin of the path; it fades from there [length/time^2].
    Vec3 bend_at_begin(const Bodies& bodies, BodyId i) const
    {
        return is_damped() ? Vec3(bend(i) - drag_ * bodies.velocity[index(i)]) : bend(i);
    }

    void stop_at(Bodies& bodies, BodyId i, double time)
    {
        bodies.position[index(i)] = place(bodies, i, time);
        bodies.velocity[index(i)] = velocity(bodies, i, time);
        since_[index(i)] = time;
    }

    /// After stop_at, with another velocity or acceleration.
    void go_on(const Bodies& bodies, FreeMotion& motion, BodyId i)
    {
        target[index(i)] = place(bodies, i, length_);
        ++changes_[index(i)];
        if (motion.track().is_wanted()) motion.track().turn(index(i), leg(bodies, i, bodies.velocity[index(i)]));
    }

    double length() const { return length_; }
    bool is_bent() const { return is_bent_; }
    bool is_damped() const { return is_bent_ && drag_ > 0; }  ///< bent, and not parabolas
    double drag() const { return drag_; }                     ///< k >= 0 [1/time]
    double since(BodyId i) const { return since_[index(i)]; }
    std::uint64_t changes(BodyId i) const { return changes_[index(i)]; }  ///< of the path, since the run began

    std::vector<Vec3> target;        ///< [length]
    std::vector<Vec3> acceleration;  ///< with Integrator::euler spent at the begin of a substep [length/time^2]

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }
    /// Rate of change of a velocity by acceleration and drag [length/time^2].
    Vec3 rate(std::size_t i, const Vec3& velocity) const;
    /// \param before velocity that drag acts on, of a straight path
    Leg leg(const Bodies& bodies, BodyId i, const Vec3& before) const;

    double length_ = 0;          ///< [time]
    double drag_ = 0;            ///< [1/time]
    bool is_bent_ = false;       ///< parabolas, not straight
    std::vector<double> since_;  ///< since the begin of the substep [time]
    std::vector<std::uint64_t> changes_;
};

}  // namespace carom::stepping
