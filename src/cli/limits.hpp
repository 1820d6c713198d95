/// \file
/// The limits of commands and of what they say: unit, value, reason.
#pragma once

#include <cstddef>
#include <cstdint>

namespace carom::cli {

/// Whole number [1] of an option, such as --max-events: a double holds it exactly.
inline constexpr long long largest_count = 1'000'000'000'000'000;
/// Repeats [runs] of a timing: more are taken for this many.
inline constexpr long long most_repeats = 1'000'000;
/// Values [1] of a range such as 1:2:lin5: each is a run.
inline constexpr long long most_range_values = 100'000;

/// Frames [1] of a run: their times are kept, and nobody has room for more.
inline constexpr double most_frames = 1e8;

/// Limit [s] from which on a command has none: 30 years, which the clock's own numbers hold.
inline constexpr double longest_limit = 1e9;

/// Time [s] before a progress line is shown: shorter runs need none.
inline constexpr double progress_after = 1;
/// Time [s] between two of its changes: an eye follows five a second.
inline constexpr double progress_every = 0.2;

/// Per cent [1] in a whole: that is what the word means.
inline constexpr double per_cent = 100;
/// Bodies [lines] that a table lists one by one: more would push the rest off the screen.
inline constexpr std::size_t most_listed_bodies = 10;
/// Findings [lines] of a trace that a table lists: the rest is in audit.json.
inline constexpr std::size_t most_listed_findings = 20;
/// Gain of energy [largest kinetic energy] that is rounding: contacts and flights give none.
inline constexpr double energy_rounding = 1e-9;

}  // namespace carom::cli
