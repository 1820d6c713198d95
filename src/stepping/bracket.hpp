/// \file
/// Bisection of a bracket: the last moment at which a condition does not yet hold.
#pragma once

#include "stepping/tolerances.hpp"

#include <cstdint>

namespace carom::stepping {

/// Two moments, neighbours but for lack of halvings.
struct Bracket {
    double before;  ///< the condition does not hold yet
    double after;   ///< it holds
};

/// \pre holds(lo) is false, holds(hi) is true. Ends after at most 64 halvings, which is when lo and hi are neighbours
/// unless lo is many orders below hi.
template <class Holds>
Bracket bisect(double lo, double hi, Holds&& holds, std::int64_t& evaluations)
{
    for (int k = 0; k < most_halvings; ++k) {
        const double mid = lo + (hi - lo) / 2;
        if (!(mid > lo && mid < hi)) break;
        ++evaluations;
        (holds(mid) ? hi : lo) = mid;
    }
    return {lo, hi};
}

}  // namespace carom::stepping
