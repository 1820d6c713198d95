#include "toi/sphere_sphere.hpp"

#include "toi/enclosure.hpp"
#include "toi/exact_signs.hpp"
#include "toi/level_0.hpp"
#include "toi/scaling.hpp"
#include "toi/tolerances.hpp"

#include <cmath>

namespace carom {

namespace {

/// Levels 1 and 2.
Root solve_exactly(const Vec3& r, const Vec3& v, double s)
{
    const Enclosure<DoubleDouble> sharp = enclose(exactly(r), exactly(v), DoubleDouble(s));
    const RootKind kind = sharp.decided == Decision::impact ? RootKind::impact : RootKind::none;
    return {kind, sharp.t.high, sharp.level};
}

/// Level 0, for pairs not certainly separating; bounds hold for values whose exponents are moderate.
Root solve(const Vec3& r, const Vec3& v, double s)
{
    const SphereQuadratic q = sphere_quadratic(r.x(), r.y(), r.z(), v.x(), v.y(), v.z(), s);
    if (q.d < -q.d_error) return {};
    // A nearly closed gap is cancellation in c, a grazing path in d: the time would lose digits long before the
    // decision does.
    if (!certainly_impact(q) || q.c < cancelled_below * q.s2 || q.d < cancelled_below * q.as)
        return solve_exactly(r, v, s);
    return {RootKind::impact, q.c / (std::sqrt(q.d) - q.b), 0};
}

}  // namespace

Root sphere_sphere_root(const Vec3& r, const Vec3& v, double contact_distance)
{
    // Half of all queries end here. Whatever overflows or underflows does not pass for "certainly separating".
    const double p1 = r.x() * v.x(), p2 = r.y() * v.y(), p3 = r.z() * v.z();
    if (p1 + p2 + p3 > level_0::b_rounding * (std::abs(p1) + std::abs(p2) + std::abs(p3)) + b_underflow) return {};

    const double length = std::max(largest(r), contact_distance), speed = largest(v);
    if (is_moderate(length) && is_moderate(speed)) return solve(r, v, contact_distance);
    if (!(speed > 0)) return {};
    // Powers of two scale exactly, but for components that vanish beside others: then the exact levels see to it, with
    // the numbers as they came.
    const int l = exponent_of(length), w = exponent_of(speed);
    Root root = solve(scaled(r, -l), scaled(v, -w), std::ldexp(contact_distance, -l));
    if (root.level > 0) return solve_exactly(r, v, contact_distance);
    root.t = std::ldexp(root.t, l - w);
    return root;
}

int approach_sign(const Vec3& r, const Vec3& v)
{
    const double p1 = r.x() * v.x(), p2 = r.y() * v.y(), p3 = r.z() * v.z();
    const double b = p1 + p2 + p3;
    if (std::abs(b) > level_0::b_rounding * (std::abs(p1) + std::abs(p2) + std::abs(p3)) + b_underflow)
        return b < 0 ? -1 : 1;
    const DoubleDouble3 x = exactly(r), y = exactly(v);
    const DoubleDouble q1 = x.x * y.x, q2 = x.y * y.y, q3 = x.z * y.z;
    const DoubleDouble sharper = (q1 + q2) + q3;
    if (std::abs(sharper.high) > level_1::b_rounding * (std::abs(p1) + std::abs(p2) + std::abs(p3)) + b_underflow)
        return sharper.high < 0 ? -1 : 1;
    return exact_approach(exact(x), exact(y)).sign();
}

}  // namespace carom
