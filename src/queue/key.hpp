/// \file
/// What a scheduled event is and when: the total order that makes a run reproducible bit for bit.
#pragma once

#include "core/partner.hpp"
#include "flight/frame.hpp"

#include <compare>

namespace carom {

/// Values are the order among equal times.
enum class Scheduled : std::uint8_t {
    pair_impact,   ///< of two spheres, a the smaller id
    plane_impact,  ///< of sphere a and a plane
    series_end,    ///< sphere a comes to rest on its plane
    intrusion,  ///< a sphere reaches the swept ball of a series, or that ball a plane; of two spheres a is the smaller
    piece_end,  ///< a numeric step or a window of sphere a ends; there is no partner
    cell_crossing,  ///< sphere a leaves its grid cell through a wall
    nothing         ///< an idle slot
};

struct Key {
    EpochTime time = never;
    Scheduled kind = Scheduled::nothing;
    BodyId a = no_body;
    Partner b{};

    friend constexpr auto operator<=>(const Key&, const Key&) = default;
};

}  // namespace carom
