/// \file
/// Where spheres are inside a substep, for samples that fall there.
#pragma once

#include "stepping/bodies.hpp"
#include "stepping/damped_times.hpp"

#include <vector>

namespace carom::stepping {

/// A piece of a sphere's path, straight or a parabola, with drag a damped flight. Its velocity is that of the method at
/// both ends, and between them as on that path, linear without drag: with semi-implicit Euler, which moves with the
/// velocity of the end, that is not the slope of the path.
struct Leg {
    double begin = 0;                  ///< since the begin of the substep [time]
    Vec3 position = Vec3::Zero();      ///< then [length]
    Vec3 slope = Vec3::Zero();         ///< of the path, then [length/time]
    Vec3 bend = Vec3::Zero();          ///< of the path [length/time^2]
    Vec3 velocity = Vec3::Zero();      ///< then [length/time]
    Vec3 acceleration = Vec3::Zero();  ///< [length/time^2]
    double drag = 0;                   ///< of the path and the velocity [1/time]

    Vec3 place_at(double time) const { return place_after(damped_times(drag, time - begin), position, slope, bend); }
    Vec3 velocity_at(double time) const
    {
        return velocity_after(damped_times(drag, time - begin), drag, velocity, acceleration);
    }
};

class SubstepTrack {
public:
    /// The next substep is to be remembered, or not: it costs a copy of all states.
    void want(bool wanted) { is_wanted_ = wanted; }
    bool is_wanted() const { return is_wanted_; }

    void clear(std::size_t spheres)
    {
        first_.assign(spheres, {});
        later_.clear();
    }
    /// The leg on which a sphere begins the substep.
    void begin(std::size_t sphere, const Leg& leg) { first_[sphere] = leg; }
    /// A leg after a corner of the path. Those of one sphere come in the order of time.
    void turn(std::size_t sphere, const Leg& leg) { later_.push_back({sphere, leg}); }

    /// \param time since the begin of the substep \param states of all spheres; their positions and velocities change
    void show(double time, const Bodies& bodies, std::vector<BodyState>& states) const
    {
        std::vector<const Leg*> leg(first_.size());
        for (std::size_t i = 0; i < first_.size(); ++i) leg[i] = &first_[i];
        for (const Turn& turn : later_)
            if (turn.leg.begin <= time) leg[turn.sphere] = &turn.leg;
        for (std::size_t i = 0; i < first_.size(); ++i) {
            states[i].position = leg[i]->place_at(time) - bodies.origin;
            states[i].velocity = leg[i]->velocity_at(time);
        }
    }

private:
    struct Turn {
        std::size_t sphere;
        Leg leg;
    };

    bool is_wanted_ = false;
    std::vector<Leg> first_;
    std::vector<Turn> later_;
};

}  // namespace carom::stepping
