/// \file
/// Heights above planes: a dot product and a difference that cancel, by compensated sums.
#pragma once

#include "math/error_free.hpp"
#include "motion/state.hpp"

namespace carom {

/// n.x - d of a plane: a dot product in twice the working precision (Ogita, Rump, Oishi, SIAM J. Sci. Comput. 26
/// (2005), Dot2) [length].
inline Sum signed_height(const Frame& frame, const Vec3& normal, double offset, const Place& place)
{
    Sum sum{-offset, 0};
    const auto add = [&](double n, double x) {
        const Sum product = two_product(n, x), next = two_sum(sum.high, product.high);
        sum = {next.high, sum.low + (next.low + product.low)};
    };
    for (int k = 0; k < 3; ++k) {
        if (normal[k] == 0) continue;  // most planes lie along the axes
        add(normal[k], static_cast<double>(place.cell[k]) * frame.cell_size);
        add(normal[k], place.local[k]);
    }
    return two_sum(sum.high, sum.low);
}

inline Sum signed_height(const Frame& frame, const Plane& plane, const Place& place)
{
    return signed_height(frame, plane.normal, plane.offset, place);
}

/// The normal of a plane on the side where the place is: plates have two.
inline Vec3 facing_normal(const State& state, int p, const Place& place)
{
    const Plane& plane = state.plane(p);
    if (plane.thickness && signed_height(state.frame, plane, place).high < 0) return -plane.normal;
    return plane.normal;
}

/// Height of a sphere's surface above a plane [length].
inline double height_above(const State& state, BodyId body, int p, const Place& place)
{
    const Plane& plane = state.plane(p);
    Sum height = signed_height(state.frame, plane, place);
    double reach = state.radius(body);
    if (plane.thickness) {
        if (height.high < 0) height = {-height.high, -height.low};
        const Sum both = two_sum(reach, *plane.thickness / 2);
        reach = both.high;
        height.low -= both.low;
    }
    const Sum gap = two_sum(height.high, -reach);
    return gap.high + (gap.low + height.low);
}

}  // namespace carom
