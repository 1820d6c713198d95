#include "toi/sphere_plane.hpp"

#include "math/error_free.hpp"

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

}  // namespace

Root plane_root(double h, double w, double g)
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

}  // namespace carom
