#include "study/convergence.hpp"

#include "core/expect.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::study {

std::optional<FittedOrder> fitted_order(std::span<const StepError> points)
{
    if (points.size() < steps_of_a_fit) return std::nullopt;
    const auto n = static_cast<double>(points.size());
    double x_mean = 0, y_mean = 0;
    for (const StepError& p : points) {
        CAROM_EXPECT(p.dt > 0 && p.error > 0);
        x_mean += std::log(p.dt) / n;
        y_mean += std::log(p.error) / n;
    }
    double xx = 0, xy = 0, residual = 0;
    for (const StepError& p : points) {
        const double x = std::log(p.dt) - x_mean;
        xx += x * x;
        xy += x * (std::log(p.error) - y_mean);
    }
    if (!(xx > 0)) return std::nullopt;
    const double order = xy / xx;
    for (const StepError& p : points) {
        const double off = std::log(p.error) - y_mean - order * (std::log(p.dt) - x_mean);
        residual += off * off;
    }
    return FittedOrder{order, std::sqrt(residual / (n - 2) / xx), points.size()};
}

bool is_stalled(std::span<const StepError> points, double exact)
{
    if (points.size() < steps_of_a_fit) return false;
    std::size_t count = steps_of_a_fit;
    while (count < points.size() && points[points.size() - 1 - count].dt <= stall_span * points.back().dt) ++count;
    const auto last = points.last(count);
    if (std::any_of(last.begin(), last.end(), [&](const StepError& p) { return p.error <= exact; })) return false;
    const std::optional<FittedOrder> fit = fitted_order(last);
    return fit && fit->order < stalled_order;
}

}  // namespace carom::study
