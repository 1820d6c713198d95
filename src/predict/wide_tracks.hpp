/// \file
/// The looks of Tracks on registers of four doubles (AVX2). They round otherwise than those for one body; both leave
/// out only what certainly does not come, so that runs are the same, bit for bit.
#pragma once

#include "predict/tracks.hpp"

#include <cstddef>

namespace carom {

/// Whether the machine has these registers. \pre of the functions below
bool has_wide_registers();

/// Meetings of a body, see Tracks::meetings. \returns their number
template <bool gravity>
std::size_t find_wide(const Track* tracks, BodyId body, double age, double least_square, std::span<const BodyId> near,
                      Meeting* found);

/// Bodies that may be in reach, and all those with accelerations. \returns their number
std::size_t in_reach_wide(const Track* tracks, const Track& own, double age, std::span<const BodyId> near,
                          BodyId* found);

}  // namespace carom
