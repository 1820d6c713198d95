/// \file
/// Unequal accelerations: F(t) = |r(t)|^2 - S^2 is a quartic, and no polynomial with drag. It is never expanded;
/// intervals are halved until on each of them F is convex or concave and so lies above its tangents or its chord.
///
/// With w = r' and b = w' = a - k w, of which |b| only shrinks: F''/2 = w.w + r.b, F'''/2 = 3 w.b - k r.b,
/// F''''/2 = 3 b.b - 4 k w.b + k^2 r.b.
#include "verify/pair_gap.hpp"

#include <algorithm>
#include <array>

namespace carom::verification {

namespace {

/// F, half its rate, and bounds for what the second derivative is made of, at one time.
struct Point {
    double t = 0, f = 0, rate = 0, f_error = 0, rate_error = 0;
    double curvature = 0;                   ///< F''/2 at this time
    double slack = 0;                       ///< its error, generously
    double change = 0;                      ///< |F'''/2| at this time
    double place = 0, speed = 0, bend = 0;  ///< |r|, |w|, |b|
};

template <class N>
class Quartic {
public:
    Quartic(const PairSegment& s, const Contact<N>& contact)
        : start_(relative<N>(s.a, s.acceleration_a, s.b, s.acceleration_b, s.from)),
          a_(s.acceleration_a - s.acceleration_b),
          drag_(s.a.drag),
          contact_(contact)
    {
        // The difference of two accelerations is exact in N, not in double.
        const Vec3 low(two_sum(s.acceleration_a.x(), -s.acceleration_b.x()).low,
                       two_sum(s.acceleration_a.y(), -s.acceleration_b.y()).low,
                       two_sum(s.acceleration_a.z(), -s.acceleration_b.z()).low);
        exact_ = {joined<N>(a_.x(), low.x()), joined<N>(a_.y(), low.y()), joined<N>(a_.z(), low.z())};
    }

    /// \param n time after the segment's start; may be off by a rounding of 1 + n
    Point at(const N& n) const
    {
        const N half(0.5);
        const double t = rounded(n);
        Damped<N> effect{};
        if (drag_ > 0) effect = damped<N>(drag_, n);
        const auto place = [&](const N& r, const N& v, const N& a) {
            return drag_ > 0 ? r + (effect.way * v + effect.fall * a) : r + n * (v + n * (half * a));
        };
        const auto speed = [&](const N& v, const N& a) {
            return drag_ > 0 ? effect.decay * v + effect.way * a : v + n * a;
        };
        const Vector<N> p{place(start_.r.x, start_.v.x, exact_.x), place(start_.r.y, start_.v.y, exact_.y),
                          place(start_.r.z, start_.v.z, exact_.z)};
        const Vector<N> w{speed(start_.v.x, exact_.x), speed(start_.v.y, exact_.y), speed(start_.v.z, exact_.z)};
        const Vec3 r0 = rounded(start_.r).cwiseAbs(), v0 = rounded(start_.v).cwiseAbs(), a = a_.cwiseAbs();
        const Vec3 p_error = start_.r_error + t * start_.v_error + rounding<N> * (r0 + (t + 1) * (v0 + t * a));
        const Vec3 w_error = start_.v_error + rounding<N> * (1 + drag_ * (t + 1)) * (v0 + (t + 1) * a);
        const Vec3 ps = rounded(p), ws = rounded(w), pa = ps.cwiseAbs(), wa = ws.cwiseAbs();
        const N pp = dot(p, p);
        Point point;
        point.t = t;
        point.f = rounded(pp - contact_.square);
        point.f_error = 2 * pa.dot(p_error) + p_error.squaredNorm() + rounding<N> * (rounded(pp) + contact_.size);
        point.rate = rounded(dot(p, w));
        point.rate_error = pa.dot(w_error) + wa.dot(p_error) + p_error.dot(w_error) + rounding<N> * pa.dot(wa);
        const Vec3 b = a_ - drag_ * ws, size = a + drag_ * wa;
        point.curvature = ws.squaredNorm() + ps.dot(b);
        point.slack = curvature_slack * (ws.squaredNorm() + pa.dot(size));
        point.change = std::abs(3 * ws.dot(b) - drag_ * ps.dot(b)) + curvature_slack * (3 * wa + drag_ * pa).dot(size);
        point.place = ps.norm();
        point.speed = ws.norm();
        point.bend = b.norm() + curvature_slack * size.norm();
        return point;
    }
    /// The change of F''/2 over a time h after a point, at most.
    double spread(const Point& x, double h) const
    {
        const double speed = x.speed + h * x.bend, place = x.place + h * speed;
        const double fourth = x.bend * (3 * x.bend + drag_ * (4 * speed + drag_ * place));
        return change_rounded_up * h * (x.change + 0.5 * h * fourth) + x.slack;
    }

private:
    Relative<N> start_;
    Vec3 a_;
    double drag_;  ///< [1/epoch]
    Vector<N> exact_;
    Contact<N> contact_;
};

/// A lower bound on [x.t, y.t], sharp if `sharp`.
struct Below {
    double value, error;
    bool sharp;
};

template <class N>
Below below(const Point& x, const Point& y, const Quartic<N>& quartic)
{
    const double h = (y.t - x.t) * interval_rounded_up, spread = quartic.spread(x, h);
    const double least = std::min(x.f, y.f), error = std::max(x.f_error, y.f_error);
    if (x.curvature + spread <= 0) return {least, error, true};  // concave: above its chord
    if (x.curvature - spread >= 0) {                             // convex: above its tangents
        if (x.rate - x.rate_error >= 0) return {x.f, x.f_error, true};
        if (y.rate + y.rate_error <= 0) return {y.f, y.f_error, true};
        const double from_x = x.f + 2 * (std::min(0.0, x.rate) - x.rate_error) * h;
        const double from_y = y.f - 2 * (std::max(0.0, y.rate) + y.rate_error) * h;
        const double value = std::max(from_x, from_y);
        return {value, error, least - value <= error};
    }
    const double value = least - 0.25 * (std::max(0.0, x.curvature) + spread) * h * h;
    return {value, error, least - value <= error};
}

}  // namespace

template <class N>
Least least_accelerated(const PairSegment& s, const Contact<N>& contact)
{
    const Quartic<N> quartic(s, contact);
    struct Interval {
        Point from, to;
        int depth;
    };
    std::array<Interval, most_interval_halvings + 2> stack;
    std::size_t n = 0;
    stack[n++] = {quartic.at(N(0.0)), quartic.at(between<N>(s.from, s.to)), 0};
    const double end = stack[0].to.t;
    double seen = std::numeric_limits<double>::infinity(), low = seen, where = 0;
    for (int i = 0; i < most_intervals && n > 0; ++i) {
        const Interval now = stack[--n];
        for (const Point& point : {now.from, now.to})
            if (point.f < seen) {
                seen = point.f;
                where = point.t;
            }
        const Below bound = below(now.from, now.to, quartic);
        const double middle = now.from.t + 0.5 * (now.to.t - now.from.t);
        const bool indivisible = now.depth >= most_interval_halvings || !(middle > now.from.t && middle < now.to.t);
        // Good enough if clear of contact, or as sharp as the arithmetic.
        if (bound.sharp || bound.value - bound.error > 0 || indivisible) {
            low = std::min(low, bound.value - bound.error);
            continue;
        }
        const Point centre = quartic.at(N(middle));
        stack[n++] = {centre, now.to, now.depth + 1};
        stack[n++] = {now.from, centre, now.depth + 1};
    }
    return {seen, std::max(0.0, seen - low), where<end / 2, n> 0};
}

template Least least_accelerated<double>(const PairSegment&, const Contact<double>&);
template Least least_accelerated<DoubleDouble>(const PairSegment&, const Contact<DoubleDouble>&);

}  // namespace carom::verification
