#include "toi/damped_sphere_sphere.hpp"

#include "flight/damping.hpp"
#include "math/dyadic.hpp"
#include "toi/closing_pieces.hpp"
#include "toi/enclosure.hpp"
#include "toi/exact_signs.hpp"
#include "toi/limits.hpp"
#include "toi/scaling.hpp"
#include "toi/sphere_plane.hpp"
#include "toi/sphere_sphere.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The time of a contact on a straight line that is known to meet the contact sphere, after more than the half of the
/// way 1/k. With p the place at its end, times k, and E = 1 - k s, p - v E is the place times k: the first contact is
/// the largest root E of |v|^2 E^2 - 2 p.v E + |p|^2 - k^2 S^2, if it is above 0.
Root late_contact(const AcceleratedMotion& m, double k)
{
    const Dyadic drag(k), reach = drag * Dyadic(m.contact_distance);
    const Dyadic3 r = exact(exactly(m.r)), v = exact(exactly(m.v));
    const Dyadic3 p{drag * r.x + v.x, drag * r.y + v.y, drag * r.z + v.z};
    const Dyadic a = dot(v, v), b = dot(p, v), c = exact_gap(p, reach);
    if (b.sign() <= 0 && c.sign() >= 0) return {};
    // Units in which a is of order 1: of a square speed for a, b and c.
    const int unit = -a.exponent();
    const DoubleDouble root = sqrt(exact_discriminant(p, v, reach).rounded(2 * unit));
    const DoubleDouble sharp_b = b.rounded(unit);
    const DoubleDouble left = b.sign() > 0 ? (sharp_b + root) / a.rounded(unit) : -c.rounded(unit) / (root - sharp_b);
    if (!(left.high > 0)) return {};
    return detail::impact_at(std::max(0.0, -logarithm(left.high)) / k);
}

Root straight_root(const AcceleratedMotion& m, double k)
{
    Root root = sphere_sphere_root(m.r, m.v, m.contact_distance);
    if (root.kind != RootKind::impact || root.t == 0) return root;
    if (k * root.t > logarithm_near_1) return late_contact(m, k);
    root.t = time_of_way(k, root.t);
    return root;
}

/// F = |p|^2 - S^2 and H = p.w = F'/2 at double times, w the velocity, signs right even where double arithmetic cannot
/// tell.
class DampedGap {
public:
    DampedGap(const AcceleratedMotion& m, double k)
        : m_(m),
          k_(k),
          r_(std::sqrt(m.r.squaredNorm())),
          v_(std::sqrt(m.v.squaredNorm())),
          a_(std::sqrt(m.a.squaredNorm()))
    {
    }

    double f(double t) const
    {
        const Damping<double> d = damping(k_, t);
        const double p2 = position(d).squaredNorm(), s2 = m_.contact_distance * m_.contact_distance;
        const double value = p2 - s2;
        if (std::abs(value) > damped_gap_rounding * (p2 + s2 + reach(d) * std::sqrt(p2))) return value;
        const DoubleDouble3 p = sharp_position(damping(k_, DoubleDouble(t)));
        const DoubleDouble s = m_.contact_distance;
        return (dot(p, p) - s * s).high;
    }
    double f_rate(double t) const { return 2 * h(t); }

    double h(double t) const
    {
        const Damping<double> d = damping(k_, t);
        const double value = position(d).dot(velocity(d));
        if (std::abs(value) > damped_gap_rounding * reach(d) * (v_ * d.decay + a_ * d.way)) return value;
        const Damping<DoubleDouble> sharp = damping(k_, DoubleDouble(t));
        return dot(sharp_position(sharp), sharp.decay * exactly(m_.v) + sharp.way * exactly(m_.a)).high;
    }
    double h_rate(double t) const
    {
        const Damping<double> d = damping(k_, t);
        const Vec3 p = position(d), w = velocity(d);
        return w.squaredNorm() + p.dot(m_.a) - k_ * p.dot(w);
    }

    /// The sign-giving part of H' in s: K = w.w + p.a, and its rate [length^2/time^2].
    double turn(double t) const
    {
        const Damping<double> d = damping(k_, t);
        return velocity(d).squaredNorm() + position(d).dot(m_.a);
    }
    double turn_rate(double t) const
    {
        const Vec3 w = velocity(damping(k_, t));
        return 3 * w.dot(m_.a) - 2 * k_ * w.squaredNorm();
    }
    /// The time of the least K. K' = A + B s + a^2 s / (1 - k s) grows in s; times 1 - k s it is a quadratic.
    double time_of_least_turn() const
    {
        const Vec3 c = m_.a - k_ * m_.v;
        const double slope = 2 * m_.v.dot(c) + m_.v.dot(m_.a), b = 2 * c.squaredNorm();
        if (!(slope < 0)) return 0;
        const double mean = b - k_ * slope + a_ * a_;
        const double d = difference_of_products(mean, mean, 4 * k_ * b, -slope);
        const double s = -2 * slope / (mean + std::sqrt(std::max(d, 0.0)));
        if (k_ * s < logarithm_near_1) return time_of_way(k_, s);
        // Of s too little is left there. In E = 1 - k s: k K' = a^2 + a.c E - b E^2.
        const double ac = m_.a.dot(c), root = std::sqrt(ac * ac + 4 * (a_ * a_ * b));
        const double left = ac > 0 ? (ac + root) / (2 * b) : 2 * a_ * a_ / (root - ac);
        return -logarithm(left) / k_;
    }

    double time_of_growth(double from) const
    {
        return later(from, [&](double t) { return h(t) >= 0; });
    }
    double time_of_positive_turn(double from) const
    {
        return later(from, [&](double t) { return turn(t) > 0; });
    }

private:
    template <class Is>
    double later(double from, const Is& is) const
    {
        double step = std::sqrt(r_ / a_) + v_ / a_;
        for (double t = from + step; t < latest_growth; step *= 2, t += step)
            if (is(t)) return t;
        return infinity;
    }
    Vec3 position(const Damping<double>& d) const { return m_.r + (d.way * m_.v + d.fall * m_.a); }
    Vec3 velocity(const Damping<double>& d) const { return d.decay * m_.v + d.way * m_.a; }
    double reach(const Damping<double>& d) const { return r_ + (d.way * v_ + d.fall * a_); }
    DoubleDouble3 sharp_position(const Damping<DoubleDouble>& d) const
    {
        return exactly(m_.r) + (d.way * exactly(m_.v) + d.fall * exactly(m_.a));
    }

    const AcceleratedMotion& m_;
    const double k_, r_, v_, a_;
};

/// Roots of K, ascending.
std::size_t turning_points(const DampedGap& gap, double out[2])
{
    const auto k = [&](double t) { return gap.turn(t); };
    const auto k_rate = [&](double t) { return gap.turn_rate(t); };
    const double least = gap.time_of_least_turn();
    std::size_t n = 0;
    if (!(gap.turn(least) < 0)) return 0;
    if (gap.turn(0) > 0) out[n++] = refine(k, k_rate, 0, least, true);
    const double end = gap.time_of_positive_turn(least);
    if (end < infinity) out[n++] = refine(k, k_rate, least, end, false);
    return n;
}

Root curved_root(const AcceleratedMotion& m, double k)
{
    const DampedGap gap(m, k);
    double cuts[2];
    const std::size_t count = turning_points(gap, cuts);
    return first_closing(gap, std::span(cuts, count));
}

}  // namespace

Root damped_sphere_sphere_root(const AcceleratedMotion& m, double k)
{
    if (m.a.isZero(0)) return straight_root(m, k);
    // Lengths and accelerations near 1, as in sphere_sphere_accelerated_root.
    const int length = exponent_of(std::max(largest(m.r), m.contact_distance));
    int acceleration = exponent_of(largest(m.a));
    if ((length - acceleration) % 2 != 0) ++acceleration;
    const int time = (length - acceleration) / 2;
    const AcceleratedMotion unit{scaled(m.r, -length), scaled(m.v, time - length), scaled(m.a, -acceleration),
                                 std::ldexp(m.contact_distance, -length)};
    Root root = curved_root(unit, std::ldexp(k, time));
    root.t = std::ldexp(root.t, time);
    return root;
}

}  // namespace carom
