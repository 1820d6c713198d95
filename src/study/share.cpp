#include "study/share.hpp"

#include "core/expect.hpp"

#include <algorithm>
#include <cmath>

namespace carom::study {

Share wilson_share(std::int64_t part, std::int64_t whole, double quantile)
{
    CAROM_EXPECT(whole > 0 && part >= 0 && part <= whole);
    const auto n = static_cast<double>(whole);
    const double p = static_cast<double>(part) / n, z2 = quantile * quantile;
    const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
    const double half = quantile / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
    return {p, part == 0 ? 0 : std::max(0.0, centre - half), part == whole ? 1 : std::min(1.0, centre + half)};
}

}  // namespace carom::study
