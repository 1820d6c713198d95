#include "toi/level_1.hpp"

#include "toi/level_0.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <limits>

namespace carom {

namespace {

double magnitude_sum(const DoubleDouble3& a)
{
    return std::abs(a.x.high) + std::abs(a.y.high) + std::abs(a.z.high);
}

}  // namespace

Bounded SphereLevel1::b() const
{
    const DoubleDouble p1 = r.x * v.x, p2 = r.y * v.y, p3 = r.z * v.z;
    double error = level_1::b_rounding * (std::abs(p1.high) + std::abs(p2.high) + std::abs(p3.high)) + b_underflow;
    if (e.any()) error += padded(e.v * magnitude_sum(r) + e.r * magnitude_sum(v) + 3 * e.r * e.v);
    return {(p1 + p2) + p3, error};
}

Bounded SphereLevel1::c() const
{
    const DoubleDouble r2 = dot(r, r), s2 = s * s;
    double error = level_1::c_rounding * (r2.high + s2.high);
    if (e.any()) error += padded(2 * e.r * magnitude_sum(r) + 3 * e.r * e.r + 2 * std::abs(s.high) * e.s + e.s * e.s);
    return {r2 - s2, error};
}

Bounded SphereLevel1::d() const
{
    const DoubleDouble s2 = s * s, a = dot(v, v), as = a * s2;
    const DoubleDouble left[3] = {r.y * v.z, r.z * v.x, r.x * v.y}, right[3] = {r.z * v.y, r.x * v.z, r.y * v.x};
    const double rs[3] = {std::abs(r.x.high), std::abs(r.y.high), std::abs(r.z.high)};
    const double vs[3] = {std::abs(v.x.high), std::abs(v.y.high), std::abs(v.z.high)};
    const DoubleDouble3 c{left[0] - right[0], left[1] - right[1], left[2] - right[2]};
    const double cs[3] = {std::abs(c.x.high), std::abs(c.y.high), std::abs(c.z.high)};
    const DoubleDouble k = dot(c, c);
    double error = level_1::d_rounding * (as.high + k.high) + d_underflow;
    double input = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, l = (i + 2) % 3;
        const double products = std::abs(left[i].high) + std::abs(right[i].high);
        error += level_1::cross_rounding * cs[i] * products + level_1::cross_rounding_square * products * products;
        if (!e.any()) continue;
        const double from_input = e.v * (rs[j] + rs[l]) + e.r * (vs[j] + vs[l]) + 2 * e.r * e.v;
        input += (2 * cs[i] + level_1::cross_rounding_of_input * products + from_input) * from_input;
    }
    if (e.any()) {
        const double s2_input = 2 * std::abs(s.high) * e.s + e.s * e.s;
        input += (2 * e.v * magnitude_sum(v) + 3 * e.v * e.v) * (s2.high + s2_input) + a.high * s2_input;
        error += padded(input);
    }
    return {as - k, error};
}

double time_error(const Bounded& b, const Bounded& c, const Bounded& d, double root, double denominator)
{
    // The halves: a relative error of 1/4 in D is one of 0.134 in its root.
    if (!(b.error < -quotient_holds_within * b.value.high && c.error < quotient_holds_within * c.value.high &&
          d.error < quotient_holds_within * d.value.high))
        return 1;
    const double relative = c.error / c.value.high + (b.error + d.error / root) / denominator;
    return padded(relative) + level_1::time_rounding;
}

void widest_times(const Bounded& b, const Bounded& c, const Bounded& d, Enclosure<DoubleDouble>& out)
{
    const double root_high = std::sqrt(std::max(d.value.high, 0.0) + 2 * d.error);
    const double root_low = std::sqrt(std::max(d.value.high - 2 * d.error, 0.0));
    const double approach_high = std::max(-b.value.high, 0.0) + 2 * b.error;
    const double approach_low = std::max(-b.value.high - 2 * b.error, 0.0);
    const double gap_high = std::max(c.value.high, 0.0) + 2 * c.error;
    const double gap_low = std::max(c.value.high - 2 * c.error, 0.0);
    const double infinity = std::numeric_limits<double>::infinity();
    const double longest = approach_low + root_low;
    out.t_lo = gap_low / (approach_high + root_high) * (1 - interval_slack);
    out.t_hi = longest > 0 ? gap_high / longest * (1 + interval_slack) : infinity;
    const double t = std::max(c.value.high, 0.0) / (approach_high + std::sqrt(std::max(d.value.high, 0.0)));
    out.t = std::clamp(t, out.t_lo.high, out.t_hi.high);
}

void rescale_time(Enclosure<DoubleDouble>& out, int exponent)
{
    out.t = scaled(out.t, exponent);
    if (out.t_hi.high > 0) {  // not now
        out.t_lo = scaled_down(out.t_lo, exponent);
        out.t_hi = scaled_up(out.t_hi, exponent);
    }
    if (out.t_lo.high < std::numeric_limits<double>::infinity()) return;
    out = Enclosure<DoubleDouble>{Decision::none, {}, {}, {}, out.level};
}

}  // namespace carom
