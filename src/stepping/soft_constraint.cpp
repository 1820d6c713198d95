#include "stepping/soft_constraint.hpp"

#include <numbers>

namespace carom::stepping {

Softness make_softness(double hertz, double damping_ratio, double h)
{
    const double omega = 2 * std::numbers::pi * hertz;
    const double a = 2 * damping_ratio + h * omega;
    const double b = h * omega * a;
    return {omega / a, b / (1 + b), 1 / (1 + b)};
}

}  // namespace carom::stepping
