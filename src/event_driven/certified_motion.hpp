/// \file
/// Motions in double-double, for certified runs: what motion.hpp does for bodies in free flight, with times that no
/// exact contact can precede. A position is a Place and its low part (State::low); velocities are doubles, for they
/// begin at impacts and nothing asks them to be anything else.
#pragma once

#include "event_driven/certified_place.hpp"
#include "toi/enclosure.hpp"

namespace carom {

/// When a contact comes. `time` is a moment at which the gap is still >= 0, and which the exact time exceeds by the
/// resolution of a time, or a few of them.
struct ContactTime {
    bool comes = false;
    EpochTime time;
};

/// Quick: a time certainly before the contact, by rounding errors at most. Contacts that do not come are found out.
ContactTime rough_pair_time(const State& state, BodyId a, BodyId b);
ContactTime rough_plane_time(const State& state, BodyId body, int plane);
/// The moment at which the contact is carried out: a pure function of the two flights, not before the rough one.
EpochTime pair_time(const State& state, BodyId a, BodyId b);
EpochTime plane_time(const State& state, BodyId body, int plane);

/// How much later than the flights' present begin, in double-double: with bounds, to tell which of two contacts is
/// first. \pre both places are of one moment
Enclosure<DoubleDouble> pair_wait(const State& state, const Flown& a, BodyId id_a, const Flown& b, BodyId id_b);
Enclosure<DoubleDouble> plane_wait(const State& state, const Flown& a, BodyId id, int plane);

/// The exact sign of d|r|/dt and of dh/dt for these places and velocities.
int exact_approach_sign(const State& state, const Flown& a, const Flown& b);
int exact_plane_sign(const Vec3& normal, const Vec3& velocity);
/// Depth of the overlap, 0 where the exact gap is >= 0 [length].
double certified_penetration(const State& state, const Flown& a, BodyId id_a, const Flown& b, BodyId id_b);
double certified_penetration(const State& state, const Flown& a, BodyId id, int plane);

}  // namespace carom
