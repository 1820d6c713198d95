#include "stepping/damped_times.hpp"

#include "math/exponential.hpp"
#include "stepping/tolerances.hpp"

#include <cmath>

namespace carom::stepping {

DampedTimes damped_times(double drag, double time)
{
    if (drag == 0) return {time, time * time / 2};
    const double x = drag * time;
    if (std::abs(x) > large_damping) {
        const double s = (1 - exponential(-x)) / drag;
        return {s, (time - s) / drag};
    }
    const double tail = exponential_tail(-x);  // (x - 1 + exp(-x)) / x^2, without cancellation
    return {time * (1 - x * tail), time * time * tail};
}

}  // namespace carom::stepping
