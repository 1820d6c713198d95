/// \file
/// Pieces of motion that are no closed form: steps of numeric clusters and windows of the guard.
#pragma once

#include "event_driven/state.hpp"

namespace carom {

/// The body's flight as if it began at `now`, mid-step integrated anew: more exact than the parabola that stands for
/// the piece (see `advanced`), which bodies outside the cluster see.
Flight flight_at(const State& state, BodyId body, const EpochTime& now);

/// The parabola through the places at both ends of a piece, with the velocity of its beginning [length/time^2].
Vec3 chord_acceleration(const Vec3& displacement, const Vec3& velocity, double duration);

}  // namespace carom
