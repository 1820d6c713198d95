/// \file
/// How a sphere on one plane stops bouncing: rest by arithmetic, the Zeno series, and what it does afterwards.
#pragma once

#include "event_driven/resolve.hpp"

namespace carom {

/// Is a sphere that leaves a plane with normal speed w in fact in persistent contact? True where the next bounce would
/// be lower than the rounding of its own position, and where nothing presses and nothing of the speed is left. \param
/// gravity towards the plane [length/time^2]
bool is_rest(const State& state, BodyId body, const Flight& flight, double w, double gravity);

/// The series that begins with normal speed w.
Series make_series(const State& state, const Flight& flight, int plane, double w, double gravity,
                   const ContactLaw& law);

/// Does nothing else meet the ball that the series sweeps before it ends?
bool series_is_clear(const State& state, BodyId body, const Flight& flight, int plane, const Series& series,
                     const Neighbourhood& neighbourhood);

/// Put the body onto the plane: gap and normal speed 0, then `hold`.
void settle(const State& state, BodyId body, int plane, Flight& flight);
/// From here on the plane carries the body.
void hold(const State& state, int plane, Flight& flight);
/// Mode of a body that a plane carries.
Mode slide_or_rest(const State& state, const Flight& flight);

}  // namespace carom
