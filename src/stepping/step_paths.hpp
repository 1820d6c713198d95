/// \file
/// The motion of spheres within one substep of a method that finds contacts inside it: straight with
/// Integrator::euler, parabolas with Integrator::parabola, with corners where velocities change.
#pragma once

#include "stepping/bodies.hpp"
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
        const Vec3 straight = bodies.position[index(i)] + t * bodies.velocity[index(i)];
        return is_bent_ ? Vec3(straight + (t * t / 2) * acceleration[index(i)]) : straight;
    }

    /// \pre time >= since(i).
    Vec3 velocity(const Bodies& bodies, BodyId i, double time) const
    {
        const Vec3& v = bodies.velocity[index(i)];
        return is_bent_ ? Vec3(v + (time - since_[index(i)]) * acceleration[index(i)]) : v;
    }

    /// Rate of change of velocity on the path: none on a straight one [length/time^2].
    Vec3 bend(BodyId i) const { return is_bent_ ? acceleration[index(i)] : Vec3(Vec3::Zero()); }

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
        if (motion.track().is_wanted()) motion.track().turn(index(i), leg(bodies, i));
    }

    double length() const { return length_; }
    bool is_bent() const { return is_bent_; }
    double since(BodyId i) const { return since_[index(i)]; }
    std::uint64_t changes(BodyId i) const { return changes_[index(i)]; }  ///< of the path, since the run began

    std::vector<Vec3> target;        ///< [length]
    std::vector<Vec3> acceleration;  ///< with Integrator::euler spent at the begin of a substep [length/time^2]

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }
    Leg leg(const Bodies& bodies, BodyId i) const;

    double length_ = 0;          ///< [time]
    bool is_bent_ = false;       ///< parabolas, not straight
    std::vector<double> since_;  ///< since the begin of the substep [time]
    std::vector<std::uint64_t> changes_;
};

}  // namespace carom::stepping
