/// \file
/// The root of a function between two times at which its signs differ, to the last double.
#pragma once

#include "toi/tolerances.hpp"

#include <bit>
#include <cmath>
#include <cstdint>

namespace carom {

/// The double halfway through the bit patterns of two positive ones, or their mean if they are close: 64 halvings
/// exhaust any bracket.
inline double middle(double low, double high)
{
    if (high < mean_is_middle * low || low == 0) {
        const double mean = low + (high - low) / 2;
        if (low > 0 || high < mean_from_zero) return mean;
    }
    const auto a = std::bit_cast<std::int64_t>(low), b = std::bit_cast<std::int64_t>(high);
    return std::bit_cast<double>(a + (b - a) / 2);
}

/// Root of a function of one sign change in [low, high], to the last double: Newton from `t`, safeguarded by halving.
/// Returns the end of the final bracket at which the function has the sign it has at `high`.
template <class Function, class Rate>
double refine(const Function& function, const Rate& rate, double low, double high, bool negative_at_high, double t)
{
    double bracket = high - low;
    for (int i = 0; i < most_refinements && t > low && t < high; ++i) {
        const double value = function(t);
        if ((value < 0) == negative_at_high || value == 0)
            high = t;
        else
            low = t;
        double next = t - value / rate(t);
        // A Newton step must stay inside and the bracket must keep shrinking, else halve. Newton lands on the near
        // side: probe one ulp beyond.
        if (next == t) next = t == high ? std::nextafter(t, low) : std::nextafter(t, high);
        if (!(next > low && next < high) || (i % 3 == 2 && high - low > bracket / 2)) next = middle(low, high);
        if (i % 3 == 2) bracket = high - low;
        t = next;
    }
    return high;
}
template <class Function, class Rate>
double refine(const Function& function, const Rate& rate, double low, double high, bool negative_at_high)
{
    return refine(function, rate, low, high, negative_at_high, middle(low, high));
}

}  // namespace carom
