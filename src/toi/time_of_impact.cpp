/// \file
/// The public query: exact differences in, one value out.
#include <carom/time_of_impact.hpp>

#include "toi/accelerated_enclosure.hpp"
#include "toi/certified_time.hpp"
#include "toi/scaling.hpp"
#include "toi/scene_plane.hpp"
#include "toi/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

bool in_range(const Vec3& a)
{
    return std::abs(a.x()) <= largest_number && std::abs(a.y()) <= largest_number && std::abs(a.z()) <= largest_number;
}
bool in_range(const MovingSphere& s)
{
    return in_range(s.position) && in_range(s.velocity) && in_range(s.acceleration) && s.radius >= 0 &&
           s.radius <= largest_number;
}

DoubleDouble3 difference(const Vec3& a, const Vec3& b)
{
    return {two_sum(a.x(), -b.x()), two_sum(a.y(), -b.y()), two_sum(a.z(), -b.z())};
}

Vec3 position_at(const MovingSphere& s, double t)
{
    return s.position + t * (s.velocity + (0.5 * t) * s.acceleration);
}

/// x / |x| whatever its exponent; zero for zero.
Vec3 direction(const DoubleDouble3& x)
{
    const Vec3 heads(x.x.high, x.y.high, x.z.high);
    const double most = largest(heads);
    if (!(most > 0)) return Vec3::Zero();
    const Vec3 shorter = scaled(heads, -exponent_of(most));
    return shorter / std::sqrt(shorter.squaredNorm());
}

/// Is |x| at most the contact distance, to some digits?
bool has_digits(const DoubleDouble3& x, DoubleDouble contact_distance)
{
    const Vec3 in_contact_distances = Vec3(x.x.high, x.y.high, x.z.high) / contact_distance.high;
    return in_contact_distances.squaredNorm() < has_contact_digits;
}

/// All by one power of two, which leaves the time as it is: products of small numbers must not underflow.
ScenePlane scaled_up(ScenePlane p)
{
    const double most = std::max({largest(p.position), largest(p.velocity), largest(p.acceleration), std::abs(p.offset),
                                  p.half_thickness, p.radius});
    if (most >= own_unit_below) return p;
    for (double* x : {&p.offset, &p.half_thickness, &p.radius}) *x = std::ldexp(*x, small_query_shift);
    for (Vec3* x : {&p.position, &p.velocity, &p.acceleration}) *x = scaled(*x, small_query_shift);
    return p;
}

/// Can a double hold the time? Where products of the query underflow, exact signs may see an impact that comes later
/// than that.
bool is_representable(const CertifiedTime& time)
{
    return 0 <= time.t_lo && time.t_lo <= time.t && time.t <= time.t_hi &&
           time.t_hi <= std::numeric_limits<double>::max();
}

}  // namespace

TimeOfImpact time_of_impact(const MovingSphere& a, const MovingSphere& b)
{
    if (!in_range(a) || !in_range(b) || !(a.radius + b.radius > 0)) return {};
    const ExactMotion motion{difference(a.position, b.position), difference(a.velocity, b.velocity),
                             difference(a.acceleration, b.acceleration), two_sum(a.radius, b.radius)};
    const CertifiedTime time = certified_time(motion);
    TimeOfImpact out;
    out.level = time.level;
    if (time.status == ImpactStatus::none || !is_representable(time)) return out;
    const DoubleDouble t = time.sharp;
    const DoubleDouble3 velocity = motion.v + t * motion.a;
    const DoubleDouble3 apart = motion.r + t * (motion.v + (DoubleDouble(0.5) * t) * motion.a);
    Vec3 normal = direction(apart);
    // From more than some 2^100 contact distances away no digit of the contact is left, only that they approach.
    if (time.t > 0 && (normal.isZero(0) || !has_digits(apart, motion.contact_distance))) normal = -direction(velocity);
    // Centres that coincide at relative speed 0 can only part.
    if (normal.isZero(0)) return out;
    out.status = time.status;
    out.t = time.t;
    out.t_lo = time.t_lo;
    out.t_hi = time.t_hi;
    out.normal = normal;
    out.point = position_at(b, time.t) + b.radius * normal;
    out.approach_speed = std::max(0.0, -normal.dot(Vec3(velocity.x.high, velocity.y.high, velocity.z.high)));
    return out;
}

TimeOfImpact time_of_impact(const MovingSphere& sphere, const Plane& plane)
{
    if (!in_range(sphere) || !in_range(plane.normal) || !(std::abs(plane.offset) <= largest_number)) return {};
    const double half_thickness = plane.thickness.value_or(0) / 2;
    if (!(half_thickness >= 0 && half_thickness <= largest_number)) return {};

    ScenePlane over{plane.normal,    plane.offset,    half_thickness,     sphere.radius,
                    sphere.position, sphere.velocity, sphere.acceleration};
    if (plane.thickness) {
        const Bounded height = over.bounded_height();
        if (height.open ? over.height().sign() < 0 : height.sign < 0) {
            over.normal = -over.normal;
            over.offset = -over.offset;
        }
    }
    const CertifiedTime time = certified_time(scaled_up(over));
    TimeOfImpact out;
    out.level = time.level;
    if (time.status == ImpactStatus::none || !is_representable(time)) return out;
    out.status = time.status;
    out.t = time.t;
    out.t_lo = time.t_lo;
    out.t_hi = time.t_hi;
    out.normal = over.normal;
    const DoubleDouble t = time.sharp, half = 0.5;
    const DoubleDouble h = over.bounded_h().value, w = over.bounded_w().value, g = over.bounded_g().value;
    // Below the centre by the radius, and by the gap that is left where the motion began inside.
    const double gap_then = h.high <= 0 ? (h + t * (w + half * t * g)).high : 0;
    out.point = position_at(sphere, time.t) - (sphere.radius + gap_then) * out.normal;
    out.approach_speed = std::max(0.0, -(w + t * g).high);
    return out;
}

}  // namespace carom
