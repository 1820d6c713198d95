/// \file
/// A running maximum that a state which is not finite cannot hide from.
#pragma once

#include <cmath>

namespace carom::study {

/// largest = max(largest, value), where NaN counts as the largest of all and stays.
inline void keep_largest(double& largest, double value)
{
    if (!std::isnan(largest) && !(value <= largest)) largest = value;
}

}  // namespace carom::study
