/// \file
/// One cell of the matrix: what is thrown at what, how fast, and with which step.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace carom::tunnel {

/// The body that is thrown at. Each is a body of ordinary scenes; the wall of a box is a `wall`, too.
enum class Target : std::uint8_t {
    plate,   ///< a plane with two sides and a thickness
    sphere,  ///< a fixed sphere, whose diameter counts as its thickness
    wall     ///< a plane with one side: nothing is behind it
};
inline constexpr std::array<std::string_view, 3> target_names{"plate", "sphere", "wall"};

struct Cell {
    Target target = Target::plate;
    std::optional<double> thickness;  ///< >= 0; none for a wall [length]
    double radius = 0;                ///< of the ball, > 0 [length]
    double dt = 0;                    ///< > 0 [time]
    double speed = 0;                 ///< along the normal, or past a sphere, > 0 [length/time]

    /// Distance of the ball's centre from the target's middle at a central contact [length].
    double reach() const { return radius + thickness.value_or(0) / 2; }
    /// The only number that matters: v dt / reach.
    double number() const { return speed * dt / reach(); }
};

}  // namespace carom::tunnel
