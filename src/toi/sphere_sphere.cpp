#include "toi/sphere_sphere.hpp"

#include "math/double_double.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

constexpr double u = unit_roundoff;

DoubleDouble3 exactly(const Vec3& a)
{
    return {a.x(), a.y(), a.z()};
}

double largest(const Vec3& a)
{
    return std::max({std::abs(a.x()), std::abs(a.y()), std::abs(a.z())});
}

/// r.r - S^2 of a gap that is almost closed: eight exact terms, distilled until nothing cancels any more (Ogita, Rump,
/// Oishi, SIAM J. Sci. Comput. 26 (2005), SumK with K = 4).
DoubleDouble square_difference(const Vec3& r, double s)
{
    constexpr int count = 8, passes = 3;
    double term[count];
    for (int k = 0; k < 4; ++k) {
        const Sum product = k < 3 ? two_product(r[k], r[k]) : two_product(-s, s);
        term[2 * k] = product.low;
        term[2 * k + 1] = product.high;
    }
    for (int pass = 0; pass < passes; ++pass)
        for (int i = 1; i < count; ++i) {
            const Sum sum = two_sum(term[i], term[i - 1]);
            term[i] = sum.high;
            term[i - 1] = sum.low;
        }
    double rest = 0;
    for (int i = 0; i < count - 1; ++i) rest += term[i];
    return two_sum(term[count - 1], rest);
}

/// Level 1: the formulas of level 0 in double-double.
Root solve_in_double_double(const Vec3& r_in, const Vec3& v_in, double s_in)
{
    const DoubleDouble3 r = exactly(r_in), v = exactly(v_in);
    const DoubleDouble s2 = DoubleDouble(s_in) * DoubleDouble(s_in);
    const DoubleDouble b = dot(r, v);
    if (!(b.high < 0)) return {RootKind::none, 0, 1};
    const DoubleDouble c = square_difference(r_in, s_in);
    if (c.high <= 0) return {RootKind::impact, 0, 1};
    const DoubleDouble3 k = cross(r, v);
    const DoubleDouble d = dot(v, v) * s2 - dot(k, k);
    if (!(d.high > 0))
        return {RootKind::none, 0, 1};  // an exact double root only grazes: the gap never shrinks below 0
    return {RootKind::impact, static_cast<double>(c / (sqrt(d) - b)), 1};
}

/// Level 0, for pairs not certainly separating; bounds hold for values whose exponents are moderate.
Root solve(const Vec3& r, const Vec3& v, double s)
{
    const double p1 = r.x() * v.x(), p2 = r.y() * v.y(), p3 = r.z() * v.z();
    const double b = p1 + p2 + p3;
    const double b_error = 8 * u * (std::abs(p1) + std::abs(p2) + std::abs(p3));

    const double a = v.x() * v.x() + v.y() * v.y() + v.z() * v.z();
    const double s2 = s * s, r2 = r.x() * r.x() + r.y() * r.y() + r.z() * r.z();
    const double c = r2 - s2, c_error = 8 * u * (r2 + s2);

    const double q1 = r.y() * v.z(), q2 = r.z() * v.y(), q3 = r.z() * v.x(), q4 = r.x() * v.z(), q5 = r.x() * v.y(),
                 q6 = r.y() * v.x();
    const double k1 = q1 - q2, k2 = q3 - q4, k3 = q5 - q6;
    const double e1 = std::abs(q1) + std::abs(q2), e2 = std::abs(q3) + std::abs(q4), e3 = std::abs(q5) + std::abs(q6);
    const double k = k1 * k1 + k2 * k2 + k3 * k3, as = a * s2, d = as - k;
    // A S^2 carries 9 u: three roundings in A, one in S^2, one in the product, and the input's own.
    const double d_error = 12 * u * (as + k) + 10 * u * (std::abs(k1) * e1 + std::abs(k2) * e2 + std::abs(k3) * e3) +
                           100 * u * u * (e1 * e1 + e2 * e2 + e3 * e3);
    if (d < -d_error) return {};

    const bool certain = b < -4 * b_error && d > 4 * d_error && c > 4 * c_error;
    // A nearly closed gap is cancellation in c, a grazing path in d: the time would lose digits long before the
    // decision does.
    if (!certain || c < 0x1p-10 * s2 || d < 0x1p-10 * as) return solve_in_double_double(r, v, s);
    return {RootKind::impact, c / (std::sqrt(d) - b), 0};
}

int exponent_of(double x)
{
    int exponent = 0;
    std::frexp(x, &exponent);
    return exponent;
}

bool is_moderate(double x)
{
    return x > 0x1p-200 && x < 0x1p200;
}

}  // namespace

Root sphere_sphere_root(const Vec3& r, const Vec3& v, double contact_distance)
{
    // Half of all queries end here. Whatever overflows or underflows does not pass for "certainly separating".
    const double p1 = r.x() * v.x(), p2 = r.y() * v.y(), p3 = r.z() * v.z();
    if (p1 + p2 + p3 > 8 * u * (std::abs(p1) + std::abs(p2) + std::abs(p3))) return {};

    const double length = std::max(largest(r), contact_distance), speed = largest(v);
    if (is_moderate(length) && is_moderate(speed)) return solve(r, v, contact_distance);
    if (!(speed > 0)) return {};
    // Powers of two scale exactly; the time scales back by their difference.
    const int length_exponent = exponent_of(length), speed_exponent = exponent_of(speed);
    const auto scaled = [](const Vec3& a, int e) {
        return Vec3(std::ldexp(a.x(), e), std::ldexp(a.y(), e), std::ldexp(a.z(), e));
    };
    Root root =
        solve(scaled(r, -length_exponent), scaled(v, -speed_exponent), std::ldexp(contact_distance, -length_exponent));
    root.t = std::ldexp(root.t, length_exponent - speed_exponent);
    return root;
}

int approach_sign(const Vec3& r, const Vec3& v)
{
    const double p1 = r.x() * v.x(), p2 = r.y() * v.y(), p3 = r.z() * v.z();
    const double b = p1 + p2 + p3;
    if (std::abs(b) > 8 * u * (std::abs(p1) + std::abs(p2) + std::abs(p3))) return b < 0 ? -1 : 1;
    const DoubleDouble exact = dot(exactly(r), exactly(v));
    return exact.high < 0 ? -1 : exact.high > 0 ? 1 : 0;
}

}  // namespace carom
