/// \file
/// The tolerances of the look around a contact: unit, value, reason.
#pragma once

namespace carom {

/// Reach [1] of the quick look at bodies that may touch: rounding of places, 1e-15, would be covered by far less. No
/// derivation.
inline constexpr double look_slack = 1.00005;
/// The same [1] where one of them is in a numeric piece, which is no parabola: they differ by `step_agreement` or so.
/// No derivation.
inline constexpr double look_slack_in_pieces = 1.001;

/// Gap [smaller radius] up to which bodies are near each other: what accumulates between them is that of all. No
/// derivation.
inline constexpr double near_contact = 1e-3;

}  // namespace carom
