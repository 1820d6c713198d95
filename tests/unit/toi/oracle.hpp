/// \file
/// Times of impact in 200 digits by formulas other than the kernel's: the textbook ones, which are harmless when every
/// product is exact.
#pragma once

#include "support/multiprecision.hpp"
#include "toi/sphere_sphere_accelerated.hpp"

namespace carom::test {

struct Truth {
    bool impact = false;
    bool open = false;  ///< a sign within 64 u^2 of 0 that double-double need not tell
    Float200 t = 0;
};

inline constexpr double u2 = 0x1p-106;

/// r, v, S as stored.
inline Truth exact_sphere_sphere(const Vec3& r_in, const Vec3& v_in, double s_in)
{
    const auto r = lift<Float200>(r_in), v = lift<Float200>(v_in);
    const Float200 s = s_in, a = dot(v, v), b = dot(r, v), c = dot(r, r) - s * s, d = b * b - a * c;
    Truth truth;
    const auto within = [&](const Float200& x, const Float200& scale) { return x != 0 && abs(x) <= 64 * u2 * scale; };
    Float200 products = 0, crossed = 0;
    for (int i = 0; i < 3; ++i) {
        products += abs(r[i] * v[i]);
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const Float200 e = abs(r[j] * v[k]) + abs(r[k] * v[j]);
        crossed += abs(r[j] * v[k] - r[k] * v[j]) * e + u2 * e * e;
    }
    truth.open = within(b, products) || within(c, dot(r, r) + s * s) || within(d, a * s * s + crossed);
    if (b >= 0) return truth;
    if (c <= 0) {
        truth.impact = true;
        return truth;
    }
    if (d <= 0) return truth;
    truth.impact = true;
    truth.t = (-b - sqrt(d)) / a;
    return truth;
}

/// (-b - sqrt(b^2 - 4 a c)) / (2 a) in double: what everybody writes first. NaN if there is no t >= 0.
inline double textbook_sphere_sphere(const Vec3& r, const Vec3& v, double s)
{
    const double a = v.dot(v), b = 2 * r.dot(v), c = r.dot(r) - s * s, d = b * b - 4 * a * c;
    if (!(d >= 0)) return std::numeric_limits<double>::quiet_NaN();
    const double t = (-b - std::sqrt(d)) / (2 * a);
    return t >= 0 ? t : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace carom::test
