#include "projection/line_search.hpp"

#include <algorithm>

namespace carom {

double line_search(const UnitVectors& y, const UnitVectors& direction, std::span<const double> t,
                   std::span<const double> rate, double epsilon)
{
    double slope = 0, curvature = 0;
    for (std::size_t k = 0; k < y.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) {
            slope += y[k][c] * direction[k][c];
            curvature += direction[k][c] * direction[k][c];
        }
    struct Break {
        double tau;
        std::size_t i;
    };
    std::vector<Break> breaks;
    for (std::size_t i = 0; i < t.size(); ++i) {
        if (t[i] > 0) {
            slope -= t[i] * rate[i];
            curvature += rate[i] * rate[i] / epsilon;
            if (rate[i] > 0) breaks.push_back({epsilon * t[i] / rate[i], i});
        } else if (rate[i] < 0) {
            breaks.push_back({epsilon * t[i] / rate[i], i});
        }
    }
    std::sort(breaks.begin(), breaks.end(),
              [](const Break& p, const Break& q) { return p.tau != q.tau ? p.tau < q.tau : p.i < q.i; });
    // The derivative is continuous; at a break a half-space leaves or enters, and its own slope changes.
    double at = 0;
    for (const Break& next : breaks) {
        if (slope + (next.tau - at) * curvature >= 0) break;
        slope += (next.tau - at) * curvature;
        at = next.tau;
        curvature += (t[next.i] > 0 ? -1 : 1) * rate[next.i] * rate[next.i] / epsilon;
    }
    return curvature > 0 ? at + std::max(0.0, -slope / curvature) : at;
}

}  // namespace carom
