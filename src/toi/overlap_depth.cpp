#include "toi/overlap_depth.hpp"

#include "math/dyadic.hpp"
#include "toi/scene_plane.hpp"
#include "toi/tolerances.hpp"

#include <cmath>

namespace carom {

namespace {

/// Whether doubles show that two centres are farther apart than the radii together, as those of most queries are.
bool is_clearly_apart(const MovingSphere& a, const MovingSphere& b)
{
    const double reach = a.radius + b.radius, square = reach * reach;
    return square > least_plain_square && (a.position - b.position).squaredNorm() > clearly_apart * square;
}

}  // namespace

double overlap_depth(const MovingSphere& a, const MovingSphere& b)
{
    if (is_clearly_apart(a, b)) return 0;
    const Vec3 &p = a.position, &q = b.position;
    const DoubleDouble3 r{two_sum(p.x(), -q.x()), two_sum(p.y(), -q.y()), two_sum(p.z(), -q.z())};
    const DoubleDouble radii = two_sum(a.radius, b.radius);
    const Dyadic square = dot(exact(r), exact(r)), reach = radii;
    const Dyadic excess = reach * reach - square;
    if (excess.sign() <= 0) return 0;
    // S - |r| = (S^2 - r^2) / (S + |r|) loses no digits where |r| is almost S; in units of 2^e > S nothing overflows.
    const int e = reach.exponent();
    const DoubleDouble sum = reach.rounded(-e) + sqrt(square.rounded(-2 * e));
    return std::ldexp(static_cast<double>(excess.rounded(-2 * e) / sum), e);
}

double overlap_depth(const MovingSphere& sphere, const Plane& plane)
{
    const double half_thickness = plane.thickness.value_or(0) / 2;
    const ScenePlane over{plane.normal,    plane.offset,    half_thickness,     sphere.radius,
                          sphere.position, sphere.velocity, sphere.acceleration};
    if (!plane.thickness && over.bounded_h().is_positive()) return 0;
    const Dyadic height = over.height();
    const bool is_behind = plane.thickness && height.sign() < 0;
    const Dyadic depth = Dyadic(sphere.radius) + Dyadic(half_thickness) - (is_behind ? -height : height);
    return depth.sign() > 0 ? static_cast<double>(depth.rounded()) : 0;
}

}  // namespace carom
