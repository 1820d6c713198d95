/// \file
/// The number types in which motions are evaluated from the doubles that a run stores: one text for all of them.
/// double rounds every operation, DoubleDouble to 2^-100 or so, Dyadic not at all.
#pragma once

#include "flight/flight.hpp"
#include "math/dyadic.hpp"

#include <array>
#include <type_traits>

namespace carom {

template <class Real>
struct TripleOf {
    using Type = std::array<Real, 3>;
};
template <>
struct TripleOf<double> {
    using Type = Vec3;
};
/// Three components.
template <class Real>
using Triple = typename TripleOf<Real>::Type;

inline DoubleDouble3 as_vector(const Triple<DoubleDouble>& a)
{
    return {a[0], a[1], a[2]};
}
inline Dyadic3 as_vector(const Triple<Dyadic>& a)
{
    return {a[0], a[1], a[2]};
}

template <class Real>
Real difference(double a, double b)
{
    if constexpr (std::is_same_v<Real, DoubleDouble>)
        return two_sum(a, -b);
    else
        return Real(a) - Real(b);
}

template <class Real>
Real product(double a, double b)
{
    if constexpr (std::is_same_v<Real, DoubleDouble>)
        return two_product(a, b);
    else
        return Real(a) * Real(b);
}

/// to - from [time].
template <class Real>
Real elapsed(const Frame& frame, const EpochTime& from, const EpochTime& to)
{
    if constexpr (std::is_same_v<Real, double>)
        return frame.between(from, to);
    else
        return Real(static_cast<double>(to.epoch - from.epoch) * frame.epoch_length) +
               difference<Real>(to.offset, from.offset);
}

/// p_a - p_b [length]. The cells cancel first, as whole numbers: nothing of a far origin is left.
template <class Real>
Triple<Real> separation(const Frame& frame, const Place& a, const Place& b)
{
    Triple<Real> out;
    for (std::size_t k = 0; k < 3; ++k) {
        const double cells = static_cast<double>(a.cell[k] - b.cell[k]) * frame.cell_size;
        out[k] = Real(cells) + difference<Real>(a.local[k], b.local[k]);
        if constexpr (!std::is_same_v<Real, double>) out[k] = out[k] + difference<Real>(a.low[k], b.low[k]);
    }
    return out;
}

/// Component by component, without roundings of their own but those of the type.
template <class Real>
Triple<Real> difference(const Vec3& a, const Vec3& b)
{
    Triple<Real> out;
    for (int k = 0; k < 3; ++k) out[static_cast<std::size_t>(k)] = difference<Real>(a[k], b[k]);
    return out;
}

/// A coordinate of the way that a flight goes in a time [length], and of its velocity after it [length/time].
template <class Real>
Real displacement(double velocity, double acceleration, const Real& dt)
{
    return dt * (Real(velocity) + (Real(0.5) * dt) * Real(acceleration));
}
template <class Real>
Real velocity_after(double velocity, double acceleration, const Real& dt)
{
    return Real(velocity) + dt * Real(acceleration);
}

}  // namespace carom
