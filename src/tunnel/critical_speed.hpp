/// \file
/// The search for a critical speed, whatever is thrown at what.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace carom::tunnel {

/// Phase of a throw of the search, the middle of one of `searched_phases` equal parts of a step [1].
double searched_phase(std::size_t part);

struct CriticalSpeed {
    enum class End : std::uint8_t {
        found,  ///< the lowest speed that tunnels, within 1 %
        below,  ///< it tunnels at this one still, and nobody has looked further down
        never   ///< nothing tunnels up to this one
    };
    End end = End::never;
    double speed = 0;  ///< > 0 [length/time]
};
inline constexpr std::array<std::string_view, 3> critical_end_names{"found", "below", "never"};

/// Goes up from v dt = 0.05 chords in strides while nothing tunnels, or down while something does, then halves.
/// \param unit speed of one chord a step, > 0 [length/time]
/// \param tunnels whether some throw at a speed tunnels; none where no throw can be judged, which ends the search there
CriticalSpeed search_critical(double unit, const std::function<std::optional<bool>(double)>& tunnels);

}  // namespace carom::tunnel
