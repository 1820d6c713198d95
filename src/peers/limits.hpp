/// \file
/// The limits of talks with other engines' programs: unit, value, reason.
#pragma once

#include <cstddef>

namespace carom::peers {

/// Time [s] within which a program must answer: a run that takes longer is too long for a row that is to be repeated.
inline constexpr double longest_answer = 600;
/// Time [ms] after which a wait for a program asks whether to go on: Ctrl-C ends it so soon.
inline constexpr int question_interval = 50;
/// Bytes [1] that are read from a program at once: a pipe of Linux holds as many.
inline constexpr std::size_t read_at_once = 65536;
/// Change of velocity [|dv| of the contact] that is an answer to a throw: a hundredth of what a right answer may be off
/// by, and far above what an engine rounds.
inline constexpr double least_answer = 1e-4;

}  // namespace carom::peers
