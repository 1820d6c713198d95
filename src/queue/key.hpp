/// \file
/// What a scheduled event is and when: the total order that makes a run reproducible bit for bit.
#pragma once

#include "flight/frame.hpp"

#include <compare>

namespace carom {

/// Values are the order among equal times.
enum class Scheduled : std::uint8_t {
    pair_impact,    ///< spheres a < b
    plane_impact,   ///< sphere a, plane body b
    series_end,     ///< sphere a comes to rest on plane body b
    intrusion,      ///< a sphere reaches the swept ball of a series; a < b
    piece_end,      ///< a numeric step or a window of sphere a ends; b = a
    cell_crossing,  ///< sphere a leaves its grid cell
    nothing         ///< an idle slot
};

struct Key {
    EpochTime time = never;
    Scheduled kind = Scheduled::nothing;
    BodyId a = no_body, b = no_body;

    friend constexpr auto operator<=>(const Key&, const Key&) = default;
};

}  // namespace carom
