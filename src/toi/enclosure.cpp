#include "toi/enclosure.hpp"

#include "toi/level_0.hpp"
#include "toi/level_1.hpp"
#include "toi/scaling.hpp"
#include "toi/tolerances.hpp"

#include <limits>

namespace carom {

namespace {

/// What input errors add to the bounds of level 0; the derivation is that of SphereLevel1.
void widen(SphereQuadratic& q, const Vec3& r, const Vec3& v, double s, const SphereInputError& e)
{
    const Vec3 rs = r.cwiseAbs(), vs = v.cwiseAbs();
    q.b_error += padded(e.v * rs.sum() + e.r * vs.sum() + 3 * e.r * e.v);
    const double s2_input = 2 * s * e.s + e.s * e.s;
    q.c_error += padded(2 * e.r * rs.sum() + 3 * e.r * e.r + s2_input);
    const double cs[3] = {std::abs(q.k1), std::abs(q.k2), std::abs(q.k3)}, products[3] = {q.e1, q.e2, q.e3};
    double input = (2 * e.v * vs.sum() + 3 * e.v * e.v) * (q.s2 + s2_input) + v.squaredNorm() * s2_input;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        const double from_input = e.v * (rs[j] + rs[l]) + e.r * (vs[j] + vs[l]) + 2 * e.r * e.v;
        input += (2 * cs[i] + level_0::cross_rounding * products[i] + from_input) * from_input;
    }
    q.d_error += padded(input);
}

Enclosure<double> solve_level_0(const Vec3& r, const Vec3& v, double s, const SphereInputError& e)
{
    SphereQuadratic q = sphere_quadratic(r.x(), r.y(), r.z(), v.x(), v.y(), v.z(), s);
    if (e.any()) widen(q, r, v, s, e);
    Enclosure<double> out;
    if (certainly_none(q)) return out;
    if (certainly_impact(q)) {
        const TimeEnclosure time = time_enclosure(q);
        return {Decision::impact, time.t, time.lo, time.hi, 0};
    }
    if (q.b < -q.b_error && q.c < -q.c_error) {
        out.decided = Decision::impact;
        return out;
    }
    Enclosure<DoubleDouble> wide;
    widest_times({q.b, q.b_error}, {q.c, q.c_error}, {q.d, q.d_error}, wide);
    // Whether it is now or very soon need not be known.
    const bool certain = q.b < -q.b_error && q.d > q.d_error;
    return {certain ? Decision::impact : Decision::ambiguous, wide.t.high, wide.t_lo.high, wide.t_hi.high, 0};
}

/// Error bounds only grow; what underflows here is covered by the bounds' own terms.
SphereInputError scaled(const SphereInputError& e, int length, int speed)
{
    return {std::ldexp(e.r, length), std::ldexp(e.v, speed), std::ldexp(e.s, length)};
}

}  // namespace

Enclosure<double> enclose(const Vec3& r, const Vec3& v, double contact_distance, const SphereInputError& error)
{
    const double length = std::max({largest(r), contact_distance, error.r, error.s}),
                 speed = std::max(largest(v), error.v);
    if (is_moderate(length) && is_moderate(speed)) return solve_level_0(r, v, contact_distance, error);
    if (!(speed > 0)) return {};
    const int l = exponent_of(length), w = exponent_of(speed);
    Enclosure<double> out =
        solve_level_0(scaled(r, -l), scaled(v, -w), std::ldexp(contact_distance, -l), scaled(error, -l, -w));
    out.t = std::ldexp(out.t, l - w);
    if (out.t_hi > 0) {  // not now
        out.t_lo = scaled_down(out.t_lo, l - w);
        out.t_hi = scaled_up(out.t_hi, l - w);
    }
    if (out.t_lo < std::numeric_limits<double>::infinity()) return out;
    return {};  // a time beyond the range of doubles is none
}

Enclosure<DoubleDouble> enclose(const DoubleDouble3& r, const DoubleDouble3& v, DoubleDouble contact_distance,
                                const SphereInputError& error)
{
    const double length = std::max({largest(r), std::abs(contact_distance.high), error.r, error.s}),
                 speed = std::max(largest(v), error.v);
    Enclosure<DoubleDouble> none;
    none.level = 1;
    if (!(speed > 0)) return none;
    const bool moderate = is_moderate(length) && is_moderate(speed);
    const int l = moderate ? 0 : exponent_of(length), w = moderate ? 0 : exponent_of(speed);
    const SphereLevel1 query =
        moderate ? SphereLevel1{r, v, contact_distance, error}
                 : SphereLevel1{scaled(r, -l), scaled(v, -w), scaled(contact_distance, -l), scaled(error, -l, -w)};
    Enclosure<DoubleDouble> out = error.any() ? solve_level_1(query, NoExactSphere{})
                                              : solve_level_1(query, ExactSphere{r, v, contact_distance, l, w});
    if (l != w) rescale_time(out, l - w);
    return out;
}

}  // namespace carom
