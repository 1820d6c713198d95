/// \file
/// The tolerances of pages: unit, value, reason.
#pragma once

#include <cstddef>

namespace carom::report {

/// Component [1] of a normal along the line of sight up to which a plane is seen edge-on, as a line: it is off by a
/// pixel in a million.
inline constexpr double edge_on = 1e-6;
/// Component [1] of a normal along an axis of the view from which on a plane bounds it: 2.6 degrees, hardly seen.
inline constexpr double facing = 0.999;
/// Length [other axis] by which one axis must be longer to be the one across: sizes that are equal on paper differ by
/// rounding.
inline constexpr double longer_across = 1 + 1e-9;
/// Margin [side of the view] around what is drawn: bodies at the edge are seen whole.
inline constexpr double view_margin = 0.03;
/// Steps [1] across a view of packed tracks: 16 bits, far below a pixel.
inline constexpr double track_steps = 65535;
/// Spread along gravity [spread along the shorter of the other two axes] below which a scene is drawn from above: the
/// side would show a strip ten times as long as high.
inline constexpr double flat_part = 0.1;
/// Points [spheres x frames x tracks] of a page: 5.3 bytes each, 5 MB together, which a browser reads in a second.
inline constexpr std::size_t most_points = 1'000'000;

}  // namespace carom::report
