/// \file
/// The tolerances of predictions: unit, value, reason.
#pragma once

namespace carom {

/// Reach of a grid [sum of the largest radii, swept]: five times the 0.2 % of `cell_slack`, beside which rounding is
/// nothing.
inline constexpr double reach_slack = 1.01;

}  // namespace carom
