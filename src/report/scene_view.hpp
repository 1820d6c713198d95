/// \file
/// Picture of a scene: which two axes, which window, and tracks packed into it.
#pragma once

#include <carom/study.hpp>

#include <array>
#include <string>
#include <vector>

namespace carom::report {

using Frames = std::vector<std::vector<std::array<float, 3>>>;

struct SceneView {
    std::array<int, 2> axes{0, 2};       ///< horizontal and vertical on the page
    std::array<double, 2> min{}, max{};  ///< window [length]
    bool from_above = false;             ///< along the axis of gravity
};

/// Axes along which centres spread the widest. From the side: up is the axis of gravity (z without), across the longer
/// of the others. From above where hardly anything lies or moves along the axis of gravity, as on a table. The window
/// holds the reference's tracks with the spheres' radii, and planes met close by; steppers may leave it.
SceneView scene_view(const Scene& scene, const Comparison& comparison);

/// Base64 of little-endian 16-bit pairs, sphere by sphere, every `stride`-th frame: 0 is the window's min, 65535 its
/// max; what is outside is clamped. A run that ended early has fewer frames.
std::string packed_tracks(const SceneView& view, const Frames& frames, std::size_t stride);

/// Every how many frames one is drawn, >= 1, so that all tracks together keep within `most_points`.
std::size_t frame_stride(std::size_t spheres, std::size_t frames, std::size_t tracks);

}  // namespace carom::report
