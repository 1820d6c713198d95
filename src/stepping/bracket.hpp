/// \file
/// Bisection of a bracket: the last moment at which a condition does not yet hold.
#pragma once

#include "stepping/tolerances.hpp"

#include <cstdint>

namespace carom::stepping {

/// \pre overlaps(lo) is false, overlaps(hi) is true. \return the largest double found at which it is false, next to one
/// at which it is true. Ends after at most 64 halvings, which is when lo and hi are neighbours unless lo is many orders
/// below hi.
template <class Overlaps>
double bisect(double lo, double hi, Overlaps&& overlaps, std::int64_t& evaluations)
{
    for (int k = 0; k < most_halvings; ++k) {
        const double mid = lo + (hi - lo) / 2;
        if (!(mid > lo && mid < hi)) break;
        ++evaluations;
        (overlaps(mid) ? hi : lo) = mid;
    }
    return lo;
}

}  // namespace carom::stepping
