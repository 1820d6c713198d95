/// \file
/// The limits of linear drag (damping.hpp): unit, value, reason.
#pragma once

namespace carom {

/// Time k t [1] up to which the effect of drag comes from series: there z - 1 + exp(-z) is 0.37 z, and the difference
/// loses less than two bits beyond.
inline constexpr double damping_by_series_up_to = 1;

}  // namespace carom
