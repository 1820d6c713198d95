#include "toi/sphere_sphere_accelerated.hpp"

#include "math/double_double.hpp"
#include "toi/sphere_sphere.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace carom {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// F = |p|^2 - S^2 and H = F'/2 at double times, signs right even where double arithmetic cannot tell.
class GapFunction {
public:
    explicit GapFunction(const AcceleratedMotion& m) : m_(m) {}

    double f(double t) const
    {
        const Vec3 p = position(t);
        const double p2 = p.squaredNorm(), s2 = m_.contact_distance * m_.contact_distance;
        const double value = p2 - s2;
        const double reach = length_scale(t);
        if (std::abs(value) > gap_rounding * (p2 + s2 + reach * std::sqrt(p2))) return value;
        const DoubleDouble3 exact = exact_position(t);
        const DoubleDouble s = m_.contact_distance;
        const DoubleDouble difference = dot(exact, exact) - s * s;
        return difference.high;
    }

    double h(double t) const
    {
        const Vec3 p = position(t), w = m_.v + t * m_.a;
        const double value = p.dot(w);
        const double speed = std::sqrt(m_.v.squaredNorm()) + t * std::sqrt(m_.a.squaredNorm());
        if (std::abs(value) > gap_rate_rounding * length_scale(t) * speed) return value;
        const DoubleDouble3 exact_w = lift(m_.v) + DoubleDouble(t) * lift(m_.a);
        return dot(exact_position(t), exact_w).high;
    }

    double h_rate(double t) const
    {
        const Vec3 w = m_.v + t * m_.a;
        return w.squaredNorm() + position(t).dot(m_.a);
    }

private:
    static DoubleDouble3 lift(const Vec3& x) { return {x.x(), x.y(), x.z()}; }
    Vec3 position(double t) const { return m_.r + t * (m_.v + (0.5 * t) * m_.a); }
    double length_scale(double t) const
    {
        return std::sqrt(m_.r.squaredNorm()) +
               t * (std::sqrt(m_.v.squaredNorm()) + 0.5 * t * std::sqrt(m_.a.squaredNorm()));
    }
    DoubleDouble3 exact_position(double t) const
    {
        const DoubleDouble time = t;
        return lift(m_.r) + time * (lift(m_.v) + (DoubleDouble(0.5) * time) * lift(m_.a));
    }

    const AcceleratedMotion& m_;
};

/// Between two positive doubles, halfway through their bit patterns: 64 halvings exhaust any bracket.
double middle(double low, double high)
{
    if (high < mean_is_middle * low || low == 0) {
        const double mean = low + (high - low) / 2;
        if (low > 0 || high < mean_from_zero) return mean;
    }
    const auto a = std::bit_cast<std::int64_t>(low), b = std::bit_cast<std::int64_t>(high);
    return std::bit_cast<double>(a + (b - a) / 2);
}

/// Root of a function of one sign change in [low, high], to the last double: Newton, safeguarded by halving.
/// Returns the end of the final bracket at which the function has the sign it has at `high`.
template <class Function, class Rate>
double refine(const Function& function, const Rate& rate, double low, double high, bool negative_at_high)
{
    double t = middle(low, high);
    double bracket = high - low;
    for (int i = 0; i < most_refinements && t > low && t < high; ++i) {
        const double value = function(t);
        if ((value < 0) == negative_at_high || value == 0)
            high = t;
        else
            low = t;
        double next = t - value / rate(t);
        // A Newton step must stay inside and the bracket must keep shrinking, else halve. Newton lands on the near
        // side: probe one ulp beyond.
        if (next == t) next = t == high ? std::nextafter(t, low) : std::nextafter(t, high);
        if (!(next > low && next < high) || (i % 3 == 2 && high - low > bracket / 2)) next = middle(low, high);
        if (i % 3 == 2) bracket = high - low;
        t = next;
    }
    return high;
}

/// Later than the last change of direction: a time at which H >= 0, or infinity.
double time_of_growth(const GapFunction& gap, const AcceleratedMotion& m, double from)
{
    const double a = std::sqrt(m.a.squaredNorm());
    double step = std::sqrt(std::sqrt(m.r.squaredNorm()) / a) + std::sqrt(m.v.squaredNorm()) / a;
    for (double t = from + step; t < latest_growth; step *= 2, t += step)
        if (gap.h(t) >= 0) return t;
    return infinity;
}

/// Positive roots of H' = 3/2 a^2 t^2 + 3 (a.v) t + (v^2 + r.a), ascending.
int turning_points_of_h(const AcceleratedMotion& m, double out[2])
{
    const double a = 1.5 * m.a.squaredNorm(), b = 1.5 * m.a.dot(m.v), c = m.v.squaredNorm() + m.r.dot(m.a);
    const double d = difference_of_products(b, b, a, c);
    if (!(d > 0)) return 0;
    const double w = b > 0 ? -b - std::sqrt(d) : -b + std::sqrt(d);
    double x[2] = {w / a, c / w};
    if (x[0] > x[1]) std::swap(x[0], x[1]);
    int n = 0;
    for (double t : x)
        if (t > 0 && t < infinity) out[n++] = t;
    return n;
}

Root solve(const AcceleratedMotion& m)
{
    const GapFunction gap(m);
    const auto f = [&](double t) { return gap.f(t); };
    const auto h = [&](double t) { return gap.h(t); };
    const auto h_rate = [&](double t) { return gap.h_rate(t); };
    const auto f_rate = [&](double t) { return 2 * gap.h(t); };

    const double f0 = gap.f(0), h0 = gap.h(0);
    if (f0 <= 0 && h0 < 0) return {RootKind::impact, 0, 0};
    if (f0 <= 0 && h0 == 0 && gap.h_rate(0) <= 0) return {RootKind::pressed, 0, 0};

    double cuts[3];
    int pieces = turning_points_of_h(m, cuts);
    cuts[pieces++] = infinity;

    double low = 0, h_low = h0;
    double left = 0;  // where the current falling piece of F began
    for (int i = 0; i < pieces; ++i) {
        double high = cuts[i];
        if (high == infinity) {  // H only grows from here on
            if (h_low >= 0) return {};
            high = time_of_growth(gap, m, low);
            if (high == infinity) return {};
        }
        const double h_high = gap.h(high);
        if (h_low < 0 && h_high >= 0) {
            const double lowest = refine(h, h_rate, low, high, false);
            if (gap.f(lowest) < 0)  // it may turn round while still inside
                return {RootKind::impact, gap.f(left) <= 0 ? left : refine(f, f_rate, left, lowest, true), 0};
        } else if (h_low >= 0 && h_high < 0) {
            left = refine(h, h_rate, low, high, true);
        }
        low = high;
        h_low = h_high;
    }
    return {};
}

int exponent_of(double x)
{
    int exponent = 0;
    std::frexp(x, &exponent);
    return exponent;
}

double largest(const Vec3& a)
{
    return a.cwiseAbs().maxCoeff();
}

}  // namespace

Root sphere_sphere_accelerated_root(const AcceleratedMotion& m)
{
    if (m.a.isZero(0)) return sphere_sphere_root(m.r, m.v, m.contact_distance);
    // Scale to lengths near 1 and accelerations near 1, time following: its unit is sqrt(length / acceleration), an
    // even power.
    const int length = exponent_of(std::max(largest(m.r), m.contact_distance));
    int acceleration = exponent_of(largest(m.a));
    if ((length - acceleration) % 2 != 0) ++acceleration;
    const int time = (length - acceleration) / 2;
    const auto scaled = [](const Vec3& a, int e) {
        return Vec3(std::ldexp(a.x(), e), std::ldexp(a.y(), e), std::ldexp(a.z(), e));
    };
    const AcceleratedMotion unit{scaled(m.r, -length), scaled(m.v, time - length), scaled(m.a, -acceleration),
                                 std::ldexp(m.contact_distance, -length)};
    Root root = solve(unit);
    root.t = std::ldexp(root.t, time);
    return root;
}

}  // namespace carom
