/// \file
/// Vectors, ids and units shared by every part of carom.
///
/// Units: lengths, times and masses are in any consistent unit chosen by the scene (metre, second and kilogram, or a
/// diameter, a thermal time and a particle mass). Everything else follows:
///
/// | quantity             | unit              |
/// |----------------------|-------------------|
/// | velocity             | length / time     |
/// | acceleration         | length / time^2   |
/// | impulse              | mass length/time  |
/// | energy               | mass length^2/time^2 |
/// | restitution, tangential, attenuation | 1 |
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>

namespace carom {

using Vec3 = Eigen::Vector3d;

/// Index of a body: spheres are 0 .. N-1 in scene order. As a partner in events plane p is N + p (`Scene::plane_body`).
using BodyId = std::int32_t;
inline constexpr BodyId no_body = -1;

/// A moment, counted from the start of the run: epoch * epoch_length + offset with 0 <= offset < epoch_length.
/// The epoch length, a power of two, belongs to the run (`Outcome::epoch_length`). Splitting a time keeps its
/// resolution the same after a year as in the first second.
struct EpochTime {
    std::int64_t epoch = 0;
    double offset = 0;  ///< [time]

    friend constexpr bool operator==(const EpochTime&, const EpochTime&) = default;
    friend constexpr auto operator<=>(const EpochTime&, const EpochTime&) = default;
};

/// Motion of a sphere between two of its own events.
enum class Mode : std::uint8_t {
    flying,   ///< on a parabola, no contact
    series,   ///< bouncing on a plane, lower than `rest.series_below` radii: the bounces are summed in closed form
    sliding,  ///< in persistent contact and moving
    resting,  ///< in persistent contact, speed exactly 0
    numeric,  ///< in contacts whose normals turn: integrated in small steps
    fixed     ///< never moves
};

inline constexpr std::array<std::string_view, 6> mode_names{"flying",  "series",  "sliding",
                                                            "resting", "numeric", "fixed"};
/// The word that results and files use for a mode.
const char* name(Mode mode);

}  // namespace carom
