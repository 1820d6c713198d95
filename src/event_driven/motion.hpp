/// \file
/// Motions relative to one another, as time-of-impact queries want them. All are pure functions of the flights
/// concerned: whoever asks, and whenever, gets the same bits.
#pragma once

#include "event_driven/height.hpp"
#include "event_driven/state.hpp"
#include "toi/root.hpp"

namespace carom {

/// A sphere on a flight: its own of the state, or one that is being tried.
struct Moving {
    BodyId body;
    const Flight& flight;
    const Series* series;  ///< of a flight whose mode is series, else null
};
inline Moving moving(const State& state, BodyId body)
{
    const Flight& flight = state.flight(body);
    return {body, flight, flight.mode == Mode::series ? &state.series.at(body) : nullptr};
}

/// Of two spheres at the later of their flights' starts. A sphere in a series stands for the ball that its bounces
/// sweep.
struct PairMotion {
    EpochTime from;
    Vec3 r, v;  ///< a relative to b [length], [length/time]
    AccelerationId acceleration_a, acceleration_b;
    double contact_distance;  ///< S [length]
    bool swept;               ///< a series is involved: reaching S is an intrusion, not an impact
};
PairMotion pair_motion(const State& state, const Moving& a, const Moving& b);
Root pair_root(const State& state, const PairMotion& motion);
/// Can they not meet before `limit`, or before a numeric piece of one of them ends? A quick answer: false where it
/// takes more to know.
bool meet_too_late(const State& state, BodyId a, BodyId b, const PairMotion& motion, EpochTime limit);

/// Of a sphere above a plane, at the start of its flight.
struct PlaneMotion {
    double h, w, g;  ///< height above contact, its rate and acceleration [length], [length/time], [length/time^2]
};
PlaneMotion plane_motion(const State& state, const Moving& sphere, int plane);
/// A plane that is no plate, and no speed towards it when the flight began: quick answers before a height is measured.
inline bool recedes_at_start(const State& state, const Flight& flight, int plane)
{
    const Plane& p = state.plane(plane);
    return !p.thickness && p.normal.dot(flight.velocity) >= 0;
}

/// A quick answer before the heights are measured: no speed and no acceleration towards the plane, so there is no root.
/// Plates, which have two sides, and series always take the long way.
inline bool recedes(const State& state, const Moving& sphere, int plane)
{
    const Flight& f = sphere.flight;
    return f.mode != Mode::series && recedes_at_start(state, f, plane) &&
           (f.acceleration == Accelerations::none ||
            state.plane(plane).normal.dot(state.accelerations[f.acceleration]) >= 0);
}

/// The body's flight as if it began at `now`: same path, place and velocity of that moment. A series becomes the flight
/// between two of its bounces in which the body is.
Flight advanced(const State& state, BodyId body, const EpochTime& now);
/// Likewise the path of what a grid files: the centre, or in a series the centre without its bounces.
Flight filed_path(const State& state, BodyId body, const EpochTime& now);
/// How far beyond its swept radius a slowed series may carry a sphere [length]; 0 at tangential factor 1.
double slowed_reach(const Series& series);

}  // namespace carom
