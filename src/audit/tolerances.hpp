/// \file
/// The tolerances of the audit of traces: unit, value, reason.
#pragma once

#include <cstddef>

namespace carom::audit {

/// Roundings [1] that an engine may add to a place within some frames, one a step: a few dozen steps a frame, and they
/// seldom all go one way.
inline constexpr double engine_roundings = 100;
/// Rounding [1, part of a number] of a double: half of the last of its 53 bits.
inline constexpr double double_rounding = 0x1p-53;
/// Rounding [1, part of a number] of single precision: half of the last of its 24 bits.
inline constexpr double single_rounding = 0x1p-24;
/// Digits [1] up to which a number may be one of single precision: nine say each of them.
inline constexpr int digits_of_single = 9;
/// Roundings [1] between equal spacings of frames: of two sums, two differences, and the decimal.
inline constexpr double spacing_roundings = 8;

/// Roundings [1, of the time] of a time of impact under drag, beside the errors of frames, which are larger: twice
/// those of its gap.
inline constexpr double damped_time_roundings = 64;

/// Frames [1] of a fitted flight: two give its place and velocity, the third says that it is one.
inline constexpr std::size_t fitted_frames = 3;
/// Error [radius] of a place at the end of an interval up to which it says something of contacts: a hundredth of the
/// body is no detail that matters.
inline constexpr double coarse_error = 0.01;
/// Part [approach speed] of what closes that an answer must take: an impact takes all of it at e = 0, twice at e = 1.
inline constexpr double answer_part = 0.5;
/// Frames [1] for which a touch may wait for its answer while the bodies overlap: a body without one by then sinks.
inline constexpr std::size_t latest_answer = 8;
/// Ways [1, those of an interval] that a body may go aside of its flight if another one meets it in the interval: twice
/// its own, for an elastic impact gives at most twice the relative speed and each of two brings its own.
inline constexpr double detour = 2;

/// Findings [1] of each kind that are listed: more are counted, and nobody reads them.
inline constexpr std::size_t most_listed = 200;
/// Margin [1, part of it] by which a scene outlasts the contact that it shows.
inline constexpr double scene_margin = 0.1;

}  // namespace carom::audit
