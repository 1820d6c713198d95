/// \file
/// No impact is lost and none is invented: whether and when two spheres, or a sphere and a plane, meet is answered as
/// exact arithmetic on the numbers given would answer it, `t` within 1 ulp and always inside [t_lo, t_hi].
///
/// Details: positions, velocities, accelerations and radii are taken as the doubles that they are; their differences
/// are not rounded. No epsilon decides: a sign that double arithmetic with its error bound cannot tell is taken in
/// double-double, and one that this cannot tell exactly (`level`). A time beyond the range of doubles is no impact, one
/// below it is the smallest double. Checked against hundreds of digits on the cases that defeat the textbook formula:
/// grazing, touching, overlapping by rounding, far away, tiny and huge (tests/unit/toi, carom_toi_adversary).
///
/// Cost: some 30 ns for a miss and 400 ns for an impact; 1000 where a sign must be exact; under different accelerations
/// some 100,000. For many pairs at once: `time_of_impact_batch`.
///
/// Lengths and times are in any consistent unit. Nothing is thrown; arguments out of range are answered with `none`.
#pragma once

#include <carom/scene.hpp>
#include <carom/types.hpp>

#include <cstdint>
#include <span>

namespace carom {

/// A sphere on a parabola, given at t = 0: x(t) = position + t velocity + t^2/2 acceleration.
struct MovingSphere {
    Vec3 position = Vec3::Zero();      ///< centre [length]
    Vec3 velocity = Vec3::Zero();      ///< [length/time]
    Vec3 acceleration = Vec3::Zero();  ///< gravity, say [length/time^2]
    double radius = 0;                 ///< >= 0; of two spheres at least one > 0 [length]
};

enum class ImpactStatus : std::uint8_t {
    none,    ///< never, if these motions go on
    impact,  ///< at t > 0 the gap is closed and the bodies approach
    /// Contact at t = 0: the gap is <= 0 and the bodies approach or, at speed 0, are pressed together by their
    /// accelerations.
    touching
};

/// The first t >= 0 at which the gap is <= 0 and the bodies approach. Bodies that overlap and separate are not in an
/// impact; should they turn round, it is the moment from which they approach again. A sphere that has just bounced,
/// touching and separating, is answered with its next impact, never with the last one.
struct TimeOfImpact {
    ImpactStatus status = ImpactStatus::none;
    double t = 0;               ///< >= 0; 0 if touching or none; within 1 ulp of the exact time [time]
    double t_lo = 0, t_hi = 0;  ///< t_lo <= exact time <= t_hi [time]
    /// Normal at t, unit, from b (the plane) to a; zero if none. Its last digits go when spheres far apart meet: its
    /// error is about 2^-104 of their distance over the contact distance, where that is more than rounding.
    Vec3 normal = Vec3::Zero();
    Vec3 point = Vec3::Zero();  ///< of contact at t, on the surface of b (the plane) [length]
    double approach_speed = 0;  ///< at t, -(d gap / dt) >= 0 [length/time]
    int level = 0;              ///< arithmetic that decided the status: 0 double, 1 double-double, 2 exact

    explicit operator bool() const { return status != ImpactStatus::none; }
};

/// The time of impact of two spheres. Exchanging them turns the normal and moves the point to the other surface,
/// nothing else.
/// \pre every number is finite and of magnitude at most 2^1000, radii >= 0 with a sum > 0.
TimeOfImpact time_of_impact(const MovingSphere& a, const MovingSphere& b);

/// The time of impact of a sphere and a plane at rest. A plate is hit on the side on which the centre is at t = 0; a
/// centre in its middle counts as on the side of the normal. Material and id play no part.
/// \pre every number is finite and of magnitude at most 2^1000, the radius >= 0, the normal of unit length to rounding,
/// a thickness >= 0.
TimeOfImpact time_of_impact(const MovingSphere& sphere, const Plane& plane);

/// A time and an interval that contains the exact one; t itself within some 34 ulp, less exact where a gap is almost
/// closed.
struct ImpactTime {
    ImpactStatus status = ImpactStatus::none;
    double t = 0, t_lo = 0, t_hi = 0;  ///< 0 if touching or none [time]
};

/// The time of impact of spheres in uniform relative motion, as quickly as certainty goes: some 20 ns.
/// \param r position of one relative to the other [length] \param v relative velocity [length/time]
/// \param contact_distance sum of the radii, > 0 [length]
ImpactTime quick_time_of_impact(const Vec3& r, const Vec3& v, double contact_distance);

/// Many pairs, each number in an array of its own. All arrays are of one length.
struct RelativeMotions {
    std::span<const double> rx, ry, rz;        ///< [length]
    std::span<const double> vx, vy, vz;        ///< [length/time]
    std::span<const double> contact_distance;  ///< > 0 [length]
};
struct ImpactTimes {
    std::span<ImpactStatus> status;
    std::span<double> t, t_lo, t_hi;
};

/// The same as `quick_time_of_impact` of each pair, to the last bit, on every machine; some 3 ns a pair.
/// \throws InputError if an array has another length
void time_of_impact_batch(const RelativeMotions& pairs, const ImpactTimes& out);

/// Statuses and lower bounds only, for the keys of a queue; `t` and `t_hi` stay as they are. Some of the bounds lie a
/// few ulp lower or higher than those of the other form.
void lower_bound_batch(const RelativeMotions& pairs, const ImpactTimes& out);

}  // namespace carom
