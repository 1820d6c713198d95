/// \file
/// The law of thin walls: what share of throws with random phase a method misses.
#pragma once

#include "tunnel/contestant.hpp"

#include <optional>

namespace carom::tunnel {

/// Share missed of throws at a cell, random in phase, and at a sphere in offset, uniform over its disc. A look falls
/// into the chord c in which it is seen with probability min(1, k c / (v dt)), k being `chords_seen`; a plate's chord
/// is radius + thickness/2, that of a sphere hit at offset b sqrt((r1+r2)^2 - b^2). None for methods without a law. No
/// method that looks at all misses a wall.
std::optional<double> share_missed(const Contestant& who, const Cell& cell);

/// Speed from which on the method tunnels, k c / dt, at an offset [radius + sphere's radius]; none without a law,
/// infinite for methods that never do [length/time].
std::optional<double> critical_speed(const Contestant& who, const Cell& cell, double offset);

/// Way of the ball's centre from the contact to the middle of the target [length].
double chord_of(const Cell& cell, double offset);

}  // namespace carom::tunnel
