/// \file
/// Shares of counted cases, with the interval in which the true share lies.
#pragma once

#include "study/tolerances.hpp"

#include <cstdint>

namespace carom::study {

struct Share {
    double value = 0;          ///< in [0, 1]
    double low = 0, high = 1;  ///< ends of the interval
};

/// Share part / whole with the interval of Wilson (Probable inference, the law of succession, and statistical
/// inference, Journal of the American Statistical Association 22, 1927), which holds for few cases and for shares of 0
/// and 1 too. \param quantile of the normal distribution, two-sided \pre 0 <= part <= whole, whole > 0
Share wilson_share(std::int64_t part, std::int64_t whole, double quantile = two_sided_95);

}  // namespace carom::study
