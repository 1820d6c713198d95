/// \file
/// Orders of convergence of the rows of a comparison.
#pragma once

#include <carom/study.hpp>

#include <vector>

namespace carom::study {

/// Error below which rounding is all there is: what the reference knows, and what counts as touching [length].
double exact_error(const Scene& scene, double reference_bound);

/// One for each family with at least three steps, a factor of two apart in all, whose errors are finite and above
/// rounding. A family of which the search found a step within the tolerance is not stalled.
std::vector<Convergence> fit_orders(const Scene& scene, const Comparison& comparison);

}  // namespace carom::study
