/// \file
/// Persistent contact with one plane: how it begins, lasts and ends.
#pragma once

#include "hold/outcome.hpp"
#include "motion/state.hpp"

namespace carom {

/// Put the body onto the plane: gap and normal speed 0, then `lean`.
void settle(const State& state, int plane, Change& change);
/// From here on the plane carries the body.
void lean(const State& state, int plane, Change& change);

/// What an impulse did to a contact with a supporting plane.
enum class SupportAfterImpact : std::uint8_t { none, kept, released, pushed };
/// Impulses leave rounding behind: a body that leans on a plane keeps to it, its normal speed put back to 0, if the
/// impulse left none to speak of. It is released if pulled off, and then flies. Pushed into the plane it is left as it
/// is: that is a coupled impact.
SupportAfterImpact keep_to_support(const State& state, Change& change);

/// The mode and support of each body as the scene starts: what touches a plane (gap within 1e-9 r), does not leave it
/// and is pressed on it rests or slides there. Returns only the bodies that do.
std::vector<Change> initial_contacts(const State& state);

}  // namespace carom
