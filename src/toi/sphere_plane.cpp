#include "toi/sphere_plane.hpp"

#include "math/error_free.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

Root impact_at(double t)
{
    if (!(t < std::numeric_limits<double>::infinity())) return {};
    return {RootKind::impact, t, 0};
}

/// h <= 0: in contact or inside.
Root from_inside(double h, double w, double g)
{
    if (w < 0) return impact_at(0);
    if (!(g < 0)) return {};
    if (w == 0) return {RootKind::pressed, 0, 0};
    const double d = difference_of_products(w, w, 2 * g, h);
    if (d <= 0) return impact_at(w / -g);  // turns round while still inside: closing begins at the apex
    return impact_at((w + std::sqrt(d)) / -g);
}

Root solve(double h, double w, double g)
{
    if (h <= 0) return from_inside(h, w, g);
    if (g < 0) {
        const double root = std::sqrt(difference_of_products(w, w, 2 * g, h));
        return impact_at(w > 0 ? (w + root) / -g : 2 * h / (root - w));
    }
    if (!(w < 0)) return {};
    if (g == 0) return impact_at(h / -w);
    const double d = difference_of_products(w, w, 2 * g, h);
    if (!(d > 0)) return {};  // turns before it arrives, or only grazes
    return impact_at(2 * h / (std::sqrt(d) - w));
}

/// Neither square under the root leaves the range of doubles.
bool is_moderate(double h, double w, double g)
{
    constexpr double large = 0x1p200, small = 0x1p-200;
    if (!(std::abs(h) < large && std::abs(w) < large && std::abs(g) < large)) return false;
    return std::abs(w) > small || std::abs(g * h) > small * small || g == 0 || h == 0;
}

}  // namespace

Root plane_root(double h, double w, double g)
{
    if (is_moderate(h, w, g)) return solve(h, w, g);
    // Another unit of length, by a power of two, leaves the time as it is.
    const double speed = std::max(std::abs(w), std::sqrt(std::abs(g)) * std::sqrt(std::abs(h)));
    int exponent = 0;
    std::frexp(speed, &exponent);
    return solve(std::ldexp(h, -exponent), std::ldexp(w, -exponent), std::ldexp(g, -exponent));
}

}  // namespace carom
