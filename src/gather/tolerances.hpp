/// \file
/// The tolerances of the look around a contact: unit, value, reason.
#pragma once

#include "motion/tolerances.hpp"

#include <cstddef>
#include <cstdint>

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

// Heaps, which thresholds are for.

/// Gap [smaller radius] up to which bodies are of one heap. Broad phases show pairs that are up to 1.6e-2 apart.
inline constexpr double heap_reach = 1e-2;
/// Bodies [1] so near each other that are no heap: where more bounce together, windows are cheaper than their bounces.
/// No derivation.
inline constexpr std::size_t largest_group = 12;
/// Impacts [1 a body] of a heap in a window beyond which it is hot: more than one and the rebounds of a body that goes
/// a thirtieth of its radius or so in that time. Measured: 2 to 10 differ little.
inline constexpr std::int64_t hot_impacts = 3;
/// Bounces [1 / (1 - e)] that are to come at most: e^k = u^2.3, from the fastest to where rounding ends them.
inline constexpr double bounces_of_rounding = 37;
/// Impacts of a body [B / (1 - e)] in a window that do not accumulate where bounces go on until rounding: all bounces
/// of three contacts, half of those of a body in a packing, with B = 100 as it is unless set.
inline constexpr double bounces_in_window = 3 * bounces_of_rounding / 100;
/// Bounces [1] beyond which thresholds end them: some 1 s of computing.
inline constexpr double most_bounces = 1e6;

}  // namespace carom
