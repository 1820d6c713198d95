/// \file
/// The scene from the side: which two axes, which window, and tracks packed into it.
#pragma once

#include <carom/study.hpp>

#include <array>
#include <string>
#include <vector>

namespace carom::report {

using Frames = std::vector<std::vector<std::array<float, 3>>>;

struct SideView {
    std::array<int, 2> axes{0, 2};       ///< horizontal and vertical on the page
    std::array<double, 2> min{}, max{};  ///< window [length]
};

/// Up is the axis of gravity (z without); across is the other axis along which the reference, or else the start,
/// spreads the widest. The window holds the reference's tracks with the spheres' radii, and planes met close by;
/// steppers may leave it.
SideView side_view(const Scene& scene, const Comparison& comparison);

/// Base64 of little-endian 16-bit pairs, sphere by sphere, every `stride`-th frame: 0 is the window's min, 65535 its
/// max; what is outside is clamped. A run that ended early has fewer frames.
std::string packed_tracks(const SideView& view, const Frames& frames, std::size_t stride);

}  // namespace carom::report
