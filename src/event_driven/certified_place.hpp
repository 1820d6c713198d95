/// \file
/// Places of bodies in free flight for certified runs: a Place and its low part (State::low), and what is between two.
#pragma once

#include "event_driven/motion.hpp"
#include "math/dyadic.hpp"
#include "toi/level_1.hpp"

namespace carom {

/// Relative error of a few operations in double-double, with room.
inline constexpr double dd_error = 0x1p-100;

/// In free flight: nothing but these is advanced and predicted in double-double.
inline bool flies_freely(const Flight& f)
{
    return f.mode == Mode::flying && f.support < 0;
}
/// The gap of two such spheres is that of a uniform motion.
inline bool is_certifiable(const State& state, BodyId a, BodyId b)
{
    const Flight &fa = state.flight(a), &fb = state.flight(b);
    const auto simple = [](const Flight& f) { return flies_freely(f) || f.mode == Mode::fixed; };
    return simple(fa) && simple(fb) && fa.acceleration == fb.acceleration;
}

/// A body's flight as if it began at a later time, and the low part of its place.
struct Flown {
    Flight flight;
    Vec3 low = Vec3::Zero();
};
inline Flown at_start(const State& state, BodyId body)
{
    return {state.flight(body), state.low[static_cast<std::size_t>(body)]};
}
/// The same later.
Flown flown(const State& state, BodyId body, const EpochTime& now);

inline DoubleDouble3 lifted_separation(const Frame& frame, const Flown& a, const Flown& b)
{
    DoubleDouble r[3];
    for (int k = 0; k < 3; ++k) {
        const Place &pa = a.flight.place, &pb = b.flight.place;
        r[k] = (DoubleDouble(static_cast<double>(pa.cell[k] - pb.cell[k]) * frame.cell_size) +
                DoubleDouble(two_sum(pa.local[k], -pb.local[k]))) +
               DoubleDouble(two_sum(a.low[k], -b.low[k]));
    }
    return {r[0], r[1], r[2]};
}

/// A coordinate of a body at its flight's start, relative to cell `origin`.
inline Dyadic exact_coordinate(const Frame& frame, const Flight& f, const Vec3& low, int k, std::int64_t origin)
{
    return Dyadic(static_cast<double>(f.place.cell[k] - origin) * frame.cell_size) + Dyadic(f.place.local[k]) +
           Dyadic(low[k]);
}

inline Dyadic3 exact_separation(const Frame& frame, const Flown& a, const Flown& b)
{
    Dyadic r[3];
    for (int k = 0; k < 3; ++k) {
        const std::int64_t origin = b.flight.place.cell[k];
        r[k] =
            exact_coordinate(frame, a.flight, a.low, k, origin) - exact_coordinate(frame, b.flight, b.low, k, origin);
    }
    return {r[0], r[1], r[2]};
}
inline Dyadic3 exact_difference(const Vec3& a, const Vec3& b)
{
    return {Dyadic(a.x()) - Dyadic(b.x()), Dyadic(a.y()) - Dyadic(b.y()), Dyadic(a.z()) - Dyadic(b.z())};
}

}  // namespace carom
