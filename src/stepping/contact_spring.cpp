#include "stepping/contact_spring.hpp"

#include <cmath>
#include <numbers>

namespace carom::stepping {

double damping_ratio(double restitution)
{
    if (restitution == 0) return 1;
    const double decay = -std::log(restitution);
    return decay / std::sqrt(std::numbers::pi * std::numbers::pi + decay * decay);
}

double stable_step(double frequency, double damping_ratio)
{
    return 2 * (std::sqrt(1 + damping_ratio * damping_ratio) - damping_ratio) / frequency;
}

}  // namespace carom::stepping
