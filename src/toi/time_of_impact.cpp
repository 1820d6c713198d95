/// \file
/// The kernels as a public query: differences in, one value out.
#include <carom/time_of_impact.hpp>

#include "math/double_double.hpp"
#include "toi/sphere_plane.hpp"
#include "toi/sphere_sphere_accelerated.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

bool in_range(const MovingSphere& s)
{
    return s.position.allFinite() && s.velocity.allFinite() && s.acceleration.allFinite() && s.radius >= 0 &&
           std::isfinite(s.radius);
}

Vec3 position_at(const MovingSphere& s, double t)
{
    return s.position + t * (s.velocity + (0.5 * t) * s.acceleration);
}

/// x / |x| whatever its exponent; zero for zero.
Vec3 direction(const Vec3& x)
{
    const double largest = x.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return Vec3::Zero();
    const Vec3 scaled = x / largest;
    return scaled / std::sqrt(scaled.squaredNorm());
}

/// n.x - d: a dot product in twice the working precision (Ogita, Rump, Oishi, SIAM J. Sci. Comput. 26 (2005), Dot2).
DoubleDouble dot_less(const Vec3& n, const Vec3& x, double d)
{
    Sum sum{-d, 0};
    for (int k = 0; k < 3; ++k) {
        const Sum product = two_product(n[k], x[k]), next = two_sum(sum.high, product.high);
        sum = {next.high, sum.low + (next.low + product.low)};
    }
    return two_sum(sum.high, sum.low);
}

ImpactStatus status_of(const Root& root)
{
    if (root.kind == RootKind::none || !std::isfinite(root.t)) return ImpactStatus::none;
    return root.t > 0 ? ImpactStatus::impact : ImpactStatus::touching;
}

}  // namespace

TimeOfImpact time_of_impact(const MovingSphere& a, const MovingSphere& b)
{
    if (!in_range(a) || !in_range(b) || !(a.radius + b.radius > 0)) return {};
    const AcceleratedMotion motion{a.position - b.position, a.velocity - b.velocity, a.acceleration - b.acceleration,
                                   a.radius + b.radius};
    const Root root = sphere_sphere_accelerated_root(motion);
    TimeOfImpact out;
    out.level = root.level;
    const Vec3 separation = motion.r + root.t * (motion.v + (0.5 * root.t) * motion.a);
    const Vec3 normal = direction(separation);
    // Centres that coincide at relative speed 0 can only part.
    if (status_of(root) == ImpactStatus::none || normal.isZero(0)) return out;
    out.status = status_of(root);
    out.t = root.t;
    out.normal = normal;
    out.point = position_at(b, root.t) + b.radius * normal;
    out.approach_speed = std::max(0.0, -normal.dot(motion.v + root.t * motion.a));
    return out;
}

TimeOfImpact time_of_impact(const MovingSphere& sphere, const Plane& plane)
{
    if (!in_range(sphere) || !plane.normal.allFinite() || !std::isfinite(plane.offset)) return {};
    const double half_thickness = plane.thickness.value_or(0) / 2;
    if (!(half_thickness >= 0 && std::isfinite(half_thickness))) return {};

    const DoubleDouble height = dot_less(plane.normal, sphere.position, plane.offset);
    const bool behind = plane.thickness && height.high < 0;
    const Vec3 normal = behind ? Vec3(-plane.normal) : plane.normal;
    const DoubleDouble gap = (behind ? -height : height) - DoubleDouble(half_thickness) - DoubleDouble(sphere.radius);
    const double h = static_cast<double>(gap), w = static_cast<double>(dot_less(normal, sphere.velocity, 0)),
                 g = static_cast<double>(dot_less(normal, sphere.acceleration, 0));
    const Root root = plane_root(h, w, g);
    TimeOfImpact out;
    out.level = root.level;
    out.status = status_of(root);
    if (out.status == ImpactStatus::none) return out;
    out.t = root.t;
    out.normal = normal;
    // Below the centre by the radius, and by the gap that is left where the motion began inside.
    const double gap_then = h <= 0 ? h + root.t * (w + (0.5 * root.t) * g) : 0;
    out.point = position_at(sphere, root.t) - (sphere.radius + gap_then) * normal;
    out.approach_speed = std::max(0.0, -(w + root.t * g));
    return out;
}

}  // namespace carom
