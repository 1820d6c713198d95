/// \file
/// How fast errors fall with the step.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace carom::study {

struct StepError {
    double dt = 0;     ///< > 0 [time]
    double error = 0;  ///< > 0 [length]
};

/// error ~ dt^order, by least squares through the logarithms.
struct FittedOrder {
    double order = 0;
    double uncertainty = 0;  ///< standard error of the order, of how the points scatter about the line
    std::size_t steps = 0;   ///< that it was fitted to
};

/// None of fewer than three steps. \pre steps and errors are finite, no step twice
std::optional<FittedOrder> fitted_order(std::span<const StepError> points);

/// Whether errors no longer fall: the order of the steps within a factor of 64 of the smallest, of three at least, is
/// below 0.2 and their errors are above `exact`, below which rounding is all there is. \param points from the largest
/// step to the smallest
bool is_stalled(std::span<const StepError> points, double exact);

}  // namespace carom::study
