/// \file
/// The motion of spheres within one substep of the bisection method: straight, with corners where velocities change.
#pragma once

#include "stepping/bodies.hpp"

#include <cstdint>
#include <vector>

namespace carom::stepping {

/// Each sphere carries its own moment `since` of Bodies::position, and the `target` that it reaches at the end.
class StraightPaths {
public:
    explicit StraightPaths(std::size_t spheres)
        : target(spheres), since_(spheres), changes_(spheres), is_changed_(spheres)
    {
    }

    /// All from their positions, for a time of `length`.
    void begin(const Bodies& bodies, double length)
    {
        length_ = length;
        for (const BodyId i : changed_) is_changed_[index(i)] = 0;
        changed_.clear();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            since_[i] = 0;
            target[i] = bodies.position[i] + length * bodies.velocity[i];
        }
    }

    /// \pre time >= since(i).
    Vec3 place(const Bodies& bodies, BodyId i, double time) const
    {
        return bodies.position[index(i)] + (time - since_[index(i)]) * bodies.velocity[index(i)];
    }

    void stop_at(Bodies& bodies, BodyId i, double time)
    {
        bodies.position[index(i)] = place(bodies, i, time);
        since_[index(i)] = time;
    }

    /// After stop_at, with another velocity.
    void go_on(const Bodies& bodies, BodyId i)
    {
        target[index(i)] = place(bodies, i, length_);
        ++changes_[index(i)];
        if (is_changed_[index(i)]) return;
        is_changed_[index(i)] = 1;
        changed_.push_back(i);
    }

    double length() const { return length_; }
    double since(BodyId i) const { return since_[index(i)]; }
    std::uint64_t changes(BodyId i) const { return changes_[index(i)]; }  ///< of velocity, since the run began
    bool is_changed(BodyId i) const { return is_changed_[index(i)] != 0; }

    std::vector<Vec3> target;  ///< [length]

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    double length_ = 0;          ///< [time]
    std::vector<double> since_;  ///< since the begin of the substep [time]
    std::vector<std::uint64_t> changes_;
    std::vector<std::uint8_t> is_changed_;
    std::vector<BodyId> changed_;
};

}  // namespace carom::stepping
