/// \file
/// No impact is lost and none is invented: whether two spheres, or a sphere and a plane, meet is decided as exact
/// arithmetic on their relative motion decides it, but for a grazing or a start so close to touching that 106 bits
/// cannot tell.
///
/// In detail. Exact is meant on the relative motion as doubles: position, velocity and acceleration of `a` less those
/// of `b`, each coordinate rounded once; for a plane the height, its rate and its acceleration, summed in twice the
/// working precision and rounded once. "106 bits cannot tell": a decisive quantity lies within 64 u^2 of zero relative
/// to its largest term, u = 2^-53. For spheres under different accelerations the gap is a quartic in time; signs are
/// then taken at double times, so two that graze within the rounding of one time may be judged either way. A time
/// beyond the range of doubles is no impact, nor is one of spheres further apart than 2^480 times the sum of their
/// radii.
///
/// Times are within 2.5 ulp at planes and within 34 ulp between spheres, but for paths that almost graze and gaps that
/// are almost closed, of which a thousandth of the radii costs ten bits (measured against hundreds of digits, see
/// tests/unit/toi).
///
/// Lengths and times are in any consistent unit. Nothing is thrown; arguments out of range are answered with `none`.
#pragma once

#include <carom/scene.hpp>
#include <carom/types.hpp>

#include <cstdint>

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
    /// At t = 0 the gap is <= 0 and the bodies approach, or, at speed 0, are pressed together by their accelerations.
    touching
};

/// The first t >= 0 at which the gap is <= 0 and the bodies approach. Bodies that overlap and separate are not in an
/// impact; should they turn round, it is the moment from which they approach again. A sphere that has just bounced,
/// touching and separating, is answered with its next impact, never with the last one.
struct TimeOfImpact {
    ImpactStatus status = ImpactStatus::none;
    double t = 0;                ///< >= 0; 0 if touching or none [time]
    Vec3 normal = Vec3::Zero();  ///< at t, unit, from b (the plane) to a; zero if none
    Vec3 point = Vec3::Zero();   ///< of contact at t, on the surface of b (the plane) [length]
    double approach_speed = 0;   ///< at t, -(d gap / dt) >= 0 [length/time]
    int level = 0;               ///< arithmetic that decided: 0 double, 1 double-double, 2 exact

    explicit operator bool() const { return status != ImpactStatus::none; }
};

/// Of two spheres. Exchanging them turns the normal and moves the point to the other surface, nothing else.
/// \pre every number is finite, radii >= 0 with a sum > 0.
TimeOfImpact time_of_impact(const MovingSphere& a, const MovingSphere& b);

/// Of a sphere and a plane at rest. A plate is hit on the side on which the centre is at t = 0; a centre in its middle
/// counts as on the side of the normal. Material and id play no part.
/// \pre every number is finite, the radius >= 0, the normal of unit length to rounding, a thickness >= 0.
TimeOfImpact time_of_impact(const MovingSphere& sphere, const Plane& plane);

}  // namespace carom
