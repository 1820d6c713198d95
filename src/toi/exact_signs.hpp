/// \file
/// Level 2: the three quantities that decide whether two spheres in uniform relative motion meet, without rounding.
/// Their components may be doubles, double-doubles or any polynomials of them (src/math/dyadic.hpp).
#pragma once

#include "math/dyadic.hpp"

namespace carom {

/// B = r.v, half the rate of the squared distance.
inline Dyadic exact_approach(const Dyadic3& r, const Dyadic3& v)
{
    return dot(r, v);
}

/// C = r.r - S^2, negative where the spheres overlap.
inline Dyadic exact_gap(const Dyadic3& r, const Dyadic& contact_distance)
{
    return dot(r, r) - contact_distance * contact_distance;
}

/// D = A S^2 - |r x v|^2, positive if and only if the straight path runs through the contact sphere.
inline Dyadic exact_discriminant(const Dyadic3& r, const Dyadic3& v, const Dyadic& contact_distance)
{
    const Dyadic3 c{r.y * v.z - r.z * v.y, r.z * v.x - r.x * v.z, r.x * v.y - r.y * v.x};
    return dot(v, v) * (contact_distance * contact_distance) - dot(c, c);
}

}  // namespace carom
