/// \file
/// Level 0 of a sphere-sphere query: the quadratic in double with certified error bounds, and the enclosure that they
/// give. One text for scalar and batch code, so that both have the same bits; no branch, no fma, no libm but sqrt.
/// Every constant is in toi/tolerances.hpp.
#pragma once

#include "math/error_free.hpp"
#include "toi/tolerances.hpp"

#include <cmath>

namespace carom {

/// B = r.v, C = r.r - S^2, D = A S^2 - |r x v|^2 with |computed - exact| <= error, for inputs that are rounded once
/// each, and lengths and speeds (largest component or S) of at most 2^100 whose largest is at least 2^-100.
struct SphereQuadratic {
    double b, c, d;
    double b_error, c_error, d_error;
    double a, r2, s2, as;  ///< v.v, r.r, S^2, A S^2
    double e1, e2, e3, k1, k2, k3;
};

inline SphereQuadratic sphere_quadratic(double rx, double ry, double rz, double vx, double vy, double vz, double s)
{
    SphereQuadratic q;
    const double p1 = rx * vx, p2 = ry * vy, p3 = rz * vz;
    q.b = p1 + p2 + p3;
    q.b_error = level_0::b_rounding * (std::abs(p1) + std::abs(p2) + std::abs(p3)) + b_underflow;

    q.a = vx * vx + vy * vy + vz * vz;
    q.r2 = rx * rx + ry * ry + rz * rz;
    q.s2 = s * s;
    q.c = q.r2 - q.s2;
    q.c_error = level_0::c_rounding * (q.r2 + q.s2);

    const double q1 = ry * vz, q2 = rz * vy, q3 = rz * vx, q4 = rx * vz, q5 = rx * vy, q6 = ry * vx;
    q.k1 = q1 - q2;
    q.k2 = q3 - q4;
    q.k3 = q5 - q6;
    q.e1 = std::abs(q1) + std::abs(q2);
    q.e2 = std::abs(q3) + std::abs(q4);
    q.e3 = std::abs(q5) + std::abs(q6);
    const double k = q.k1 * q.k1 + q.k2 * q.k2 + q.k3 * q.k3;
    q.as = q.a * q.s2;
    q.d = q.as - k;
    // 2 |k| d + d^2 for each component k with an error of d.
    const double crossed = (std::abs(q.k1) + level_0::cross_rounding * q.e1) * q.e1 +
                           (std::abs(q.k2) + level_0::cross_rounding * q.e2) * q.e2 +
                           (std::abs(q.k3) + level_0::cross_rounding * q.e3) * q.e3;
    q.d_error = level_0::d_rounding * (q.as + k) + level_0::cross_rounding * crossed + d_underflow;
    return q;
}

// & and |, not && and ||: without branches a loop over these vectorises.

/// Certainly separating or certainly passing.
inline bool certainly_none(const SphereQuadratic& q)
{
    return (q.b > q.b_error) | (q.d < -q.d_error);
}

/// Certainly an impact later than now, and the enclosure holds.
inline bool certainly_impact(const SphereQuadratic& q)
{
    return (q.b < -quotient_holds_from * q.b_error) & (q.d > quotient_holds_from * q.d_error) &
           (q.c > quotient_holds_from * q.c_error);
}

/// A time and the ends of an interval that contains the exact one.
struct TimeEnclosure {
    double t, lo, hi;
};

/// Of the first root. \pre certainly_impact
inline TimeEnclosure time_enclosure(const SphereQuadratic& q)
{
    // t = C / den and its relative error (c_error / C + (b_error s + d_error) / (den s)), with one division for both.
    const double s = std::sqrt(q.d > 0 ? q.d : 0), den = s - q.b, ds = den * s;
    const double inverse = 1 / (ds * den);
    const double t = q.c * ds * inverse;
    const double width = (q.c_error * ds + q.c * (q.b_error * s + q.d_error)) * inverse + t * level_0::time_rounding;
    return {t, t - width, t + 2 * width};
}

/// The lower end alone, one division less. \pre certainly_impact
inline double time_lower_bound(const SphereQuadratic& q)
{
    const double s = std::sqrt(q.d > 0 ? q.d + q.d_error : 0);
    return (q.c - q.c_error) / (s + (q.b_error - q.b)) * (1 - level_0::time_rounding);
}

/// Neither squares nor products of this query leave the range in which the bounds hold. Implies that the largest
/// components are moderate (scaling.hpp).
inline bool is_moderate(const SphereQuadratic& q)
{
    constexpr double low = smallest_moderate_square, high = largest_moderate_square;
    return (q.r2 + q.s2 > low) & (q.r2 + q.s2 < high) & (q.a > low) & (q.a < high);
}

}  // namespace carom
