/// \file
/// The limits of what is read and written: unit, value, reason.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace carom::io {

// Files and texts.

/// Size [bytes] of a scene file: it also ends the reading of a device that never does.
inline constexpr std::size_t most_scene_bytes = std::size_t{1} << 30;
/// Size [bytes] of what is read at once: some pages.
inline constexpr std::size_t read_at_once = std::size_t{1} << 16;
/// Depth [levels] of JSON: a scene needs 6, and the bound keeps recursion over the tree safe.
inline constexpr std::size_t deepest_json = 64;
/// Length [bytes] of a line of toi: a query has some hundred, and a device that never ends a line is no input.
inline constexpr std::size_t longest_toi_line = std::size_t{1} << 16;
/// Whole number [1] up to which doubles hold every one: 2^53.
inline constexpr double largest_exact = 0x1p53;
/// Epochs [1] of a start time: what every reader of JSON keeps exactly, as `largest_exact`.
inline constexpr std::uint64_t most_epochs = std::uint64_t{1} << 53;
/// Digits [1] after the point of the smallest subnormal, 2^-1074: each halving adds one.
inline constexpr int most_fraction_digits = 1074;

/// Indent [spaces] of a level of JSON that is written: enough to be seen.
inline constexpr std::size_t json_indent = 2;

// Messages.

/// Problems [lines] of a file that are named; the others are counted.
inline constexpr std::size_t most_problems = 200;
/// Candidates [words] that a message lists: more are no help.
inline constexpr std::size_t most_listed = 30;
/// Bodies [ids] among which a likely one is looked for: a look compares letters with each.
inline constexpr std::size_t most_candidates = 1000;
/// Length [letters] of words that are compared: time grows with the square.
inline constexpr std::size_t longest_compared = 64;
/// Length of a word [letters] for each slip that it may have: one of six may have two.
inline constexpr std::size_t letters_per_slip = 3;
/// Length [letters] of a string that a message quotes whole.
inline constexpr std::size_t longest_quoted = 40;

/// Digits [1] of a length in a message: more are noise there.
inline constexpr int shift_digits = 6;

// Scenes.

/// Spheres [1] that fills may make in all: 20 million take 3 GB.
inline constexpr std::uint64_t most_spheres = 20'000'000;
/// Rows [1] of a triangle: 18 million spheres.
inline constexpr std::uint64_t most_triangle_rows = 6000;
/// Sine [1] of the angle between a triangle's axis and z: rows lie across axis x z, which rounding would turn.
inline constexpr double least_axis_sine = 1e-6;
/// Component [1 and its inverse] of a direction whose square is far from over- and underflow, at 1e308 and 1e-308.
inline constexpr double safe_component = 1e100;
/// Error [1] of the square of a normal's length up to which toi takes it as it is: rounding leaves 4 u.
inline constexpr double normal_to_rounding = 1e-15;

// Recordings (docs/recording.md).

/// Rows [1] of a chunk that is written: a MiB or so, which a kill may lose and a reader holds.
inline constexpr std::size_t chunk_rows = 16384;
/// Time [s] after which a chunk is written though it is not full: a kill loses less than a second.
inline constexpr std::chrono::milliseconds chunk_time{900};
/// Rows [1] between two looks at the clock, each of which costs about what a row does.
inline constexpr int clock_look_every = 8;
/// Rows [1] of a chunk that a reader accepts: what it has to hold at once, 64 times what is written.
inline constexpr std::int64_t most_chunk_rows = 1 << 20;
/// Spheres [1] of a recording that a reader accepts: more than `most_spheres`.
inline constexpr std::int64_t most_bodies = 1 << 25;
/// Ids [bytes] of a recording that a reader accepts: as large as a scene file may be.
inline constexpr std::int64_t most_bytes_of_ids = std::int64_t{1} << 30;
/// Planes, materials and contacts [rows] of a recording that a reader accepts: each is written by hand.
inline constexpr std::int64_t most_written_by_hand = 1 << 20;
/// Error [1] of the square of a recorded normal's length that a reader accepts: scenes are held to 1e-12.
inline constexpr double recorded_normal_error = 1e-9;
/// Work [values read] of a sphere of a list: its id, radius, place and velocity.
inline constexpr std::size_t work_of_a_sphere = 4;
/// Time [ms] for which the reading of a silent pipe waits before it asks whether to go on: Ctrl-C seems to act at once.
inline constexpr int longest_wait = 50;
/// Bytes [1] of a plane of a column that are looked at before compressing it: noise then agrees with itself to within
/// 1 %.
inline constexpr std::size_t compression_sample = 4096;
/// Agreement of bytes [1, that of noise] from which on compressing is worth a try: noise has each of 256 equally often.
inline constexpr double compressible_from = 2;

// Results.

/// Spheres [1] whose final states results list by themselves: a few hundred kB of JSON.
inline constexpr std::size_t max_final_spheres = 1000;

}  // namespace carom::io
