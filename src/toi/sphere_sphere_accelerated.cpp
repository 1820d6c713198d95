#include "toi/sphere_sphere_accelerated.hpp"

#include "math/double_double.hpp"
#include "toi/closing_pieces.hpp"
#include "toi/sphere_sphere.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

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
    double f_rate(double t) const { return 2 * h(t); }

    /// A time after the last change of direction at which H >= 0, or infinity.
    double time_of_growth(double from) const
    {
        const double a = std::sqrt(m_.a.squaredNorm());
        double step = std::sqrt(std::sqrt(m_.r.squaredNorm()) / a) + std::sqrt(m_.v.squaredNorm()) / a;
        for (double t = from + step; t < latest_growth; step *= 2, t += step)
            if (h(t) >= 0) return t;
        return infinity;
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
    double cuts[2];
    const int count = turning_points_of_h(m, cuts);
    return first_closing(GapFunction(m), std::span(cuts, static_cast<std::size_t>(count)));
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
