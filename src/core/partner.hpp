/// \file
/// What a sphere meets.
#pragma once

#include <carom/types.hpp>

#include <compare>

namespace carom {

/// Another sphere, a plane, or a wall of the sphere's grid cell: a kind, and a number within it.
struct Partner {
    enum class Kind : std::uint8_t { none, sphere, plane, cell_wall };

    Kind kind = Kind::none;
    std::int32_t index = 0;

    static constexpr Partner sphere(BodyId body) { return {Kind::sphere, body}; }
    static constexpr Partner plane(int plane) { return {Kind::plane, plane}; }
    /// The wall across `axis` (0 to 2), on its upper side or its lower one.
    static constexpr Partner cell_wall(int axis, bool upper) { return {Kind::cell_wall, 2 * axis + (upper ? 1 : 0)}; }

    constexpr bool is_sphere() const { return kind == Kind::sphere; }
    constexpr bool is_plane() const { return kind == Kind::plane; }

    /// Spheres come before planes, each by their numbers: the order of events at one time depends on it.
    friend constexpr auto operator<=>(const Partner&, const Partner&) = default;
};

}  // namespace carom
