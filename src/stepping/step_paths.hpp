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
        : target(spheres), since_(spheres), acceleration_(spheres, Vec3::Zero()), changes_(spheres)
    {
    }

    /// All from their positions, for a time of `length`.
    void begin(Bodies& bodies, FreeMotion& motion, double length)
    {
        length_ = length;
        is_bent_ = motion.integrator() == Integrator::parabola;
        if (!is_bent_) motion.accelerate(bodies, length);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            since_[i] = 0;
            if (is_bent_ && bodies.inverse_mass[i] > 0) acceleration_[i] = motion.gravity();
            target[i] = place(bodies, static_cast<BodyId>(i), length);
        }
    }

    /// All are where their paths end.
    void end(Bodies& bodies)
    {
        bodies.position.swap(target);
        if (!is_bent_) return;
        for (std::size_t i = 0; i < bodies.size(); ++i)
            bodies.velocity[i] = velocity(bodies, static_cast<BodyId>(i), length_);
    }

    /// \pre time >= since(i).
    Vec3 place(const Bodies& bodies, BodyId i, double time) const
    {
        const double t = time - since_[index(i)];
        const Vec3 straight = bodies.position[index(i)] + t * bodies.velocity[index(i)];
        return is_bent_ ? Vec3(straight + (t * t / 2) * acceleration_[index(i)]) : straight;
    }

    /// \pre time >= since(i).
    Vec3 velocity(const Bodies& bodies, BodyId i, double time) const
    {
        const Vec3& v = bodies.velocity[index(i)];
        return is_bent_ ? Vec3(v + (time - since_[index(i)]) * acceleration_[index(i)]) : v;
    }

    void stop_at(Bodies& bodies, BodyId i, double time)
    {
        bodies.position[index(i)] = place(bodies, i, time);
        bodies.velocity[index(i)] = velocity(bodies, i, time);
        since_[index(i)] = time;
    }

    /// After stop_at, with another velocity.
    void go_on(const Bodies& bodies, BodyId i)
    {
        target[index(i)] = place(bodies, i, length_);
        ++changes_[index(i)];
    }

    double length() const { return length_; }
    bool is_bent() const { return is_bent_; }
    double since(BodyId i) const { return since_[index(i)]; }
    std::uint64_t changes(BodyId i) const { return changes_[index(i)]; }  ///< of velocity, since the run began

    std::vector<Vec3> target;  ///< [length]

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    double length_ = 0;               ///< [time]
    bool is_bent_ = false;            ///< parabolas, not straight
    std::vector<double> since_;       ///< since the begin of the substep [time]
    std::vector<Vec3> acceleration_;  ///< [length/time^2]
    std::vector<std::uint64_t> changes_;
};

}  // namespace carom::stepping
