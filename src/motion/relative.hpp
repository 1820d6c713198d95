/// \file
/// Motions relative to one another, as time-of-impact queries want them. All are pure functions of the flights
/// concerned: the bits do not depend on when and for which body they are asked.
#pragma once

#include "motion/height.hpp"
#include "motion/number.hpp"
#include "motion/state.hpp"
#include "toi/root.hpp"

namespace carom {

/// The relative motion of two flights, at the later of their starts.
template <class Real>
struct Relative {
    EpochTime from{};
    Triple<Real> r{}, v{};  ///< a relative to b [length], [length/time]
};

/// The relative motion of two flights. Only the older one has moved since it began. \param gravity false leaves
/// accelerations out, with the same bits
template <class Real, bool gravity = true>
Relative<Real> relative_motion(const State& state, const Flight& a, const Flight& b)
{
    Relative<Real> out{a.start, separation<Real>(state.frame, a.place, b.place),
                       difference<Real>(a.velocity, b.velocity)};
    if (a.start == b.start) return out;
    const bool a_is_older = a.start < b.start;
    const Flight &older = a_is_older ? a : b, &newer = a_is_older ? b : a;
    out.from = newer.start;
    const Real dt = elapsed<Real>(state.frame, older.start, newer.start);
    const Real towards_a = a_is_older ? dt : -dt;  // rounding does not know a sign
    if (!gravity || older.acceleration == Accelerations::none) {
        for (std::size_t k = 0; k < 3; ++k) out.r[k] = out.r[k] + towards_a * Real(older.velocity[k]);
        return out;
    }
    const Vec3& g = state.acceleration(older);
    for (std::size_t k = 0; k < 3; ++k) {
        out.r[k] = out.r[k] + towards_a * (Real(older.velocity[k]) + (Real(0.5) * dt) * Real(g[k]));
        const Real v = velocity_after<Real>(older.velocity[k], g[k], dt) - Real(newer.velocity[k]);
        out.v[k] = a_is_older ? v : -v;
    }
    return out;
}

/// A sphere on a flight, which is that of the state or one on trial.
struct Moving {
    BodyId body;
    const Flight& flight;
    const Bouncing* bouncing;  ///< of a body in a series, else null
};
inline Moving moving(const State& state, BodyId body)
{
    const bool bounces = state.bodies.kind(body) == MotionKind::bouncing;
    return {body, state.flight(body), bounces ? state.bodies.as<Bouncing>(body) : nullptr};
}

/// The relative motion of two spheres. A sphere in a series stands for the ball that its bounces sweep.
struct PairMotion : Relative<double> {
    AccelerationId acceleration_a = Accelerations::none, acceleration_b = Accelerations::none;
    double contact_distance = 0;  ///< S [length]
    bool swept = false;           ///< a series is involved: reaching S is an intrusion, not an impact
};
PairMotion pair_motion(const State& state, const Moving& a, const Moving& b);
/// The same where motions are damped: nothing bounces in series then. \pre state.drag > 0
PairMotion damped_pair_motion(const State& state, BodyId a, BodyId b);
/// The one of both by which the run's bodies move.
inline PairMotion lawful_pair_motion(const State& state, BodyId a, BodyId b)
{
    if (state.drag > 0) [[unlikely]]
        return damped_pair_motion(state, a, b);
    return pair_motion(state, moving(state, a), moving(state, b));
}
Root pair_root(const State& state, const PairMotion& motion);
/// Whether two spheres certainly do not meet before `limit`, or before a piece of one of them ends. A quick answer:
/// false where it takes more to know.
bool meet_too_late(const State& state, BodyId a, BodyId b, const PairMotion& motion, EpochTime limit);

/// A sphere above a plane, at the start of its flight.
struct PlaneMotion {
    double h = 0, w = 0,
           g = 0;  ///< height above contact, its rate and acceleration [length], [length/time], [length/time^2]
};
PlaneMotion plane_motion(const State& state, const Moving& sphere, int plane);

/// Whether a flight had no speed towards a plane that is no plate when it began: a quick answer before a height is
/// measured.
inline bool recedes_at_start(const State& state, const Flight& flight, int plane)
{
    const Plane& p = state.plane(plane);
    return !p.thickness && p.normal.dot(flight.velocity) >= 0;
}

/// Whether there is no root for want of speed and acceleration towards the plane: a quick answer before a height is
/// measured. Plates, which have two sides, and series always take the long way.
inline bool recedes(const State& state, const Moving& sphere, int plane)
{
    const Flight& f = sphere.flight;
    return !sphere.bouncing && recedes_at_start(state, f, plane) &&
           (f.acceleration == Accelerations::none || state.plane(plane).normal.dot(state.acceleration(f)) >= 0);
}

/// The body's flight as if it began at `now`: same path, place and velocity of that moment, in double. A series becomes
/// the flight between two of its bounces in which the body is.
Flight advanced(const State& state, BodyId body, const EpochTime& now);
/// The path by which a grid files the body, from `now` on: that of its centre, in a series that of the centre without
/// its bounces.
Flight filed_path(const State& state, BodyId body, const EpochTime& now);
/// Distance beyond its swept radius to which a slowed series may carry a sphere [length]; 0 at tangential factor 1.
double slowed_reach(const Series& series);

}  // namespace carom
