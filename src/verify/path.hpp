/// \file
/// A flight in the verifier's own units: cells and epochs. Both are powers of two, so that nothing is lost.
#pragma once

#include "verify/drag.hpp"
#include "verify/number.hpp"

#include <carom/flight.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom::verification {

/// From flights to paths.
struct Units {
    double length = 1, time = 1;  ///< [length], [time], powers of two

    double speed(double v) const { return v / length * time; }
    double acceleration(double a) const { return a / length * time * time; }
    EpochTime moment(const EpochTime& t) const { return {t.epoch, t.offset / time}; }
    double seconds(const EpochTime& t) const { return (static_cast<double>(t.epoch) + t.offset) * time; }
};

struct Path {
    EpochTime start;  ///< 0 <= offset < 1
    std::int64_t cell[3] = {0, 0, 0};
    double local[3] = {0, 0, 0}, local_low[3] = {0, 0, 0};      ///< [cells]
    Vec3 velocity = Vec3::Zero(), velocity_low = Vec3::Zero();  ///< [cells/epoch]
    std::int32_t acceleration = 0, support = -1;                ///< as in FlightRecord
    Vec3 own = Vec3::Zero();                                    ///< acceleration of its own, if so [cells/epoch^2]
    Mode mode = Mode::flying;
    bool guarded = false;
    double drag = 0;  ///< of the run [1/epoch]
};

/// In persistent contact.
inline bool is_held(const Path& p)
{
    return p.mode == Mode::sliding || p.mode == Mode::resting;
}
/// By spheres, or several planes.
inline bool is_held_by_several(const Path& p)
{
    return is_held(p) && p.support == several_supports;
}

inline Vec3 vector_of(const double (&a)[3])
{
    return {a[0], a[1], a[2]};
}

/// The second derivative of a place from a moment on is at most this, a coordinate each: drag makes it smaller
/// [cells/epoch^2]. \param speed at that moment [cells/epoch]
inline Vec3 largest_bend(const Path& p, const Vec3& a, const Vec3& speed)
{
    return a.cwiseAbs() + p.drag * speed.cwiseAbs();
}

/// Part of a time for which a speed lasts: with drag 1/k at most [epochs].
inline double lasting(const Path& p, double time)
{
    return p.drag > 0 ? std::min(time, 1 / p.drag) : time;
}
/// Way of a flight in a time, at most, a coordinate each [cells].
inline Vec3 longest_way(const Path& p, const Vec3& a, double time)
{
    return lasting(p, time) * (p.velocity.cwiseAbs() + time * a.cwiseAbs());
}

/// to - from [epochs].
template <class N>
N between(const EpochTime& from, const EpochTime& to)
{
    const auto epochs = static_cast<double>(to.epoch - from.epoch);
    if constexpr (std::is_same_v<N, double>) return epochs + (to.offset - from.offset);
    return N(epochs) + (N(to.offset) - N(from.offset));
}

/// Where somebody is at a moment: place from a base cell, and speed, with the sizes of the parts that made them up.
template <class N>
struct Moving {
    Vector<N> place, speed;
    Vec3 place_size, speed_size;
};

/// \pre if N is exact, the flight is not damped, or begins at that moment
template <class N>
Moving<N> moving(const Path& p, const Vec3& a, const std::int64_t (&base)[3], const EpochTime& at)
{
    Moving<N> m;
    const bool moved = at != p.start;
    const N tau = moved ? between<N>(p.start, at) : N(0.0);
    // A unit more: what the offsets of the two times may have lost.
    const double span = moved ? std::abs(between<double>(p.start, at)) + 1 : 0;
    const Vec3 way = longest_way(p, a, span);
    Damped<N> effect{};
    if constexpr (rounding < N >> 0)
        if (moved && p.drag > 0) effect = damped<N>(p.drag, between<DoubleDouble>(p.start, at));
    N* const place[] = {&m.place.x, &m.place.y, &m.place.z};
    N* const speed[] = {&m.speed.x, &m.speed.y, &m.speed.z};
    for (int k = 0; k < 3; ++k) {
        const auto cells = static_cast<double>(p.cell[k] - base[k]);
        const N v = joined<N>(p.velocity[k], p.velocity_low[k]);
        N x = N(cells) + joined<N>(p.local[k], p.local_low[k]);
        m.place_size[k] = std::abs(cells) + std::abs(p.local[k]);
        m.speed_size[k] = std::abs(p.velocity[k]);
        if (!moved) {
            *place[k] = x;
            *speed[k] = v;
            continue;
        }
        m.speed_size[k] += std::abs(a[k]) * lasting(p, span);
        m.place_size[k] += way[k];
        if (p.drag > 0) {
            *place[k] = x + (effect.way * v + effect.fall * N(a[k]));
            *speed[k] = effect.decay * v + effect.way * N(a[k]);
        } else if (a[k] == 0) {
            *place[k] = x + tau * v;
            *speed[k] = v;
        } else {
            *place[k] = x + tau * (v + tau * N(a[k] / 2));
            *speed[k] = v + tau * N(a[k]);
        }
    }
    return m;
}

/// One body relative to another.
template <class N>
struct Relative {
    Vector<N> r, v;
    Vec3 r_error, v_error;  ///< bounds; 0 if N is exact
};

template <class N>
Relative<N> relative(const Path& a, const Vec3& acceleration_a, const Path& b, const Vec3& acceleration_b,
                     const EpochTime& at)
{
    const Moving<N> ma = moving<N>(a, acceleration_a, b.cell, at), mb = moving<N>(b, acceleration_b, b.cell, at);
    Relative<N> r;
    r.r = {ma.place.x - mb.place.x, ma.place.y - mb.place.y, ma.place.z - mb.place.z};
    r.v = {ma.speed.x - mb.speed.x, ma.speed.y - mb.speed.y, ma.speed.z - mb.speed.z};
    r.r_error = rounding<N> * (ma.place_size + mb.place_size);
    r.v_error = rounding<N> * (ma.speed_size + mb.speed_size);
    return r;
}

}  // namespace carom::verification
