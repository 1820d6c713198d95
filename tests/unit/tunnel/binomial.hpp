/// \file
/// The exact binomial test, written for these tests alone.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace carom::test {

/// Two-sided p: the probability of all outcomes that are no likelier than `successes` of `trials`, each with chance p.
inline double binomial_p(std::int64_t successes, std::int64_t trials, double p)
{
    if (p <= 0) return successes == 0 ? 1 : 0;
    if (p >= 1) return successes == trials ? 1 : 0;
    const auto n = static_cast<double>(trials);
    const auto log_chance = [&](double k) {
        return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) + k * std::log(p) +
               (n - k) * std::log1p(-p);
    };
    const double seen = log_chance(static_cast<double>(successes));
    double sum = 0;
    for (std::int64_t k = 0; k <= trials; ++k)
        if (const double log = log_chance(static_cast<double>(k)); log <= seen + 1e-7) sum += std::exp(log);
    return std::min(1.0, sum);
}

}  // namespace carom::test
