/// \file
/// Contestants in throws: a method that moves the ball, as a function. Methods of carom, collision libraries and the
/// dummies of tests are all of this kind.
#pragma once

#include "tunnel/throw.hpp"

#include <carom/method.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace carom::tunnel {

/// Answer of a method to a throw.
struct Flown {
    std::optional<double> answered;  ///< the first response to the contact, since the begin; none without one [time]
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();          ///< two steps after the begin
    Vec3 end_position = Vec3::Zero(), end_velocity = Vec3::Zero();  ///< after all steps
};

struct Contestant {
    std::string method;                    ///< as rows name it
    std::string variant;                   ///< settings that tell rows of one method apart; may be empty
    std::optional<Integrator> integrator;  ///< of steppers
    bool is_exact = false;                 ///< claims exact times, and is held to them
    /// Law of the method: a look in the way of the ball within so many chords (the way from the contact to the middle
    /// of the target) sees it. None: no law is known; infinite: it never misses.
    std::optional<double> chords_seen;
    std::string settings;  ///< of an engine that is none of carom's, in words; empty for others
    /// Moves the body of a throw by so many steps of dt, three at least.
    std::function<Flown(const Throw&, double dt, std::int64_t steps)> fly;
};

/// A method of carom. \param options of steppers: integrator, seed
Contestant contestant(const std::string& method, const StepOptions& options = {});

}  // namespace carom::tunnel
