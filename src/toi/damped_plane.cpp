#include "toi/damped_plane.hpp"

#include "flight/damping.hpp"
#include "toi/bracketed_root.hpp"
#include "toi/limits.hpp"
#include "toi/sphere_plane.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

/// The height of a sphere, its sign right even where double arithmetic cannot tell.
class DampedHeight {
public:
    DampedHeight(double h, double w, double g, double k) : h_(h), w_(w), g_(g), k_(k) {}

    double at(double t) const
    {
        const Damping<double> d = damping(k_, t);
        const double way = w_ * d.way, fall = g_ * d.fall, value = h_ + (way + fall);
        if (std::abs(value) > damped_height_rounding * (std::abs(h_) + std::abs(way) + std::abs(fall))) return value;
        const Damping<DoubleDouble> sharp = damping(k_, DoubleDouble(t));
        return (DoubleDouble(h_) + (DoubleDouble(w_) * sharp.way + DoubleDouble(g_) * sharp.fall)).high;
    }
    double rate(double t) const
    {
        const Damping<double> d = damping(k_, t);
        return w_ * d.decay + g_ * d.way;
    }

    /// The root between a time and a later one at which the height is below 0.
    Root falls_below_0(double from, double to, double guess) const
    {
        const double step = guess - at(guess) / rate(guess);
        const double start = from < step && step < to ? step : middle(from, to);
        return detail::impact_at(
            refine([&](double t) { return at(t); }, [&](double t) { return rate(t); }, from, to, true, start));
    }

private:
    double h_, w_, g_, k_;
};

/// sqrt(x^2 + y^2), whose squares may leave the range of doubles.
double length(double x, double y)
{
    const double most = std::max(std::abs(x), std::abs(y));
    if (!(most > 0)) return 0;
    const double a = x / most, b = y / most;
    return most * std::sqrt(a * a + b * b);
}

/// The last root, where the sphere is pulled down with -g > 0 and everything before `from` is known not to matter.
Root fall(const DampedHeight& height, double h, double w, double g, double k, double from)
{
    // With s = 2 t / (2 + k t) and q = t^2 / (2 + k t), which s never is above and q never below, it is a quadratic:
    // its root is exact without drag, and for w >= 0 no earlier than that of the height.
    const double depth = std::max(h, 0.0), b = 2 * w + depth * k;
    const double root = length(b, 2 * std::sqrt(-2 * g) * std::sqrt(depth));
    const double guess = b > 0 ? (b + root) / (-2 * g) : 4 * depth / (root - b);
    double to = std::max(guess, std::nextafter(from, std::numeric_limits<double>::infinity()));
    while (to < latest_growth && !(height.at(to) < 0)) to *= 2;
    if (!(to < latest_growth)) return {};
    return height.falls_below_0(from, to, guess);
}

/// Without acceleration: s = h / -w if the way v/k is longer.
Root coast(double h, double w, double k)
{
    const double left = std::fma(-k, h, -w);  // -w (1 - k s), its sign exact
    if (!(left > 0)) return {};
    if (left < logarithm_near_1 * -w) return detail::impact_at(-logarithm(left / -w) / k);
    return detail::impact_at(time_of_way(k, h / -w));
}

}  // namespace

Root damped_plane_root(double h, double w, double g, double k)
{
    if (h <= 0 && w < 0) return detail::impact_at(0);
    const DampedHeight height(h, w, g, k);
    if (g < 0) {
        if (h <= 0 && w == 0) return {RootKind::pressed, 0, 0};
        const double top = w > 0 ? turning_time(k, w, -g) : 0;
        if (h <= 0 && height.at(top) <= 0) return detail::impact_at(top);  // turns round while still inside
        return fall(height, h, w, g, k, top);
    }
    if (!(w < 0)) return {};
    if (g == 0) return coast(h, w, k);
    const double bottom = turning_time(k, -w, g);
    if (!(height.at(bottom) < 0)) return {};  // turns before it arrives, or only grazes
    return height.falls_below_0(0, bottom, h / -w);
}

}  // namespace carom
