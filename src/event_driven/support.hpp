/// \file
/// Persistent contact with one plane: how it begins, lasts and ends.
#pragma once

#include "event_driven/resolve.hpp"

namespace carom {

/// Put the body onto the plane: gap and normal speed 0, then `hold`.
void settle(const State& state, BodyId body, int plane, Flight& flight);
/// From here on the plane carries the body.
void hold(const State& state, int plane, Flight& flight);

/// What an impulse did to a contact with a supporting plane.
enum class SupportAfterImpact : std::uint8_t { none, kept, released, pushed };
/// Impulses leave rounding behind: a body on a support keeps to its plane, its normal speed put back to 0, if the
/// impulse left none to speak of. It is released if pulled off, and then flies. Pushed into the plane it is left as it
/// is: that is a coupled impact.
SupportAfterImpact keep_to_support(const State& state, Flight& flight);
/// The event of a release from the plane that carried `before`.
Event release_event(const State& state, BodyId body, const Flight& before);

}  // namespace carom
