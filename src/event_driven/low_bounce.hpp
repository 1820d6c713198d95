/// \file
/// How a sphere on one plane stops bouncing: at rest by arithmetic, or by the closed sum of a Zeno series.
#pragma once

#include "event_driven/resolve.hpp"

namespace carom {

/// Is a sphere that leaves a plane with normal speed w in fact in persistent contact? True where the next bounce would
/// be lower than the rounding of its own position, and where nothing presses and nothing of the speed is left. \param
/// gravity towards the plane [length/time^2]
bool is_rest(const State& state, BodyId body, const Flight& flight, double w, double gravity);

/// Is the next bounce one of those that are summed in closed form, not events of their own?
bool is_low(const State& state, BodyId body, double w, double gravity, const ContactLaw& law);

/// The series that begins with normal speed w.
Series make_series(const State& state, const Flight& flight, int plane, double w, double gravity,
                   const ContactLaw& law);

/// Does nothing else meet the ball that the series sweeps before it ends?
bool series_is_clear(const State& state, BodyId body, const Flight& flight, int plane, const Series& series,
                     const Neighbourhood& neighbourhood);

}  // namespace carom
