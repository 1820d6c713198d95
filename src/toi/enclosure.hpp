/// \file
/// Certified times of impact: no answer but "ambiguous" can be wrong, and the exact time lies in the interval returned.
/// For callers whose relative state is a rounding of something exact; how far it is from that goes in, too.
///
/// The event is the first t >= 0 at which the gap is <= 0 and closes (docs/numerics.md, section 1). Derivation of every
/// bound: src/toi/ERROR_BOUNDS.md.
#pragma once

#include "math/double_double.hpp"

#include <carom/types.hpp>

#include <cstdint>

namespace carom {

enum class Decision : std::uint8_t {
    none,      ///< certainly never
    impact,    ///< certainly, at a time within [t_lo, t_hi]
    pressed,   ///< certainly closed, at speed 0 and pressed (planes): a contact, not an event
    ambiguous  ///< the error bounds do not decide; if there is an impact, it lies within [t_lo, t_hi]
};

/// An answer with an interval that contains the exact time. \tparam Number double or DoubleDouble
template <class Number>
struct Enclosure {
    Decision decided = Decision::none;
    Number t{}, t_lo{}, t_hi{};  ///< all 0 if it is now; meaningless for none and pressed [time]
    std::uint8_t level = 0;      ///< arithmetic that decided: 0 double, 1 double-double, 2 exact
};

/// Errors of the numbers that go in against what is meant: absolute, for each component. All 0: they are meant exactly.
struct SphereInputError {
    double r = 0, v = 0, s = 0;  ///< [length], [length/time], [length]

    bool any() const { return r > 0 || v > 0 || s > 0; }
};

/// Two spheres in uniform relative motion, in double: some 10 ns. Each component of r, v and S may moreover be rounded
/// once.
Enclosure<double> enclose(const Vec3& r, const Vec3& v, double contact_distance, const SphereInputError& error = {});

/// The same in double-double. Without input errors it is never ambiguous: a sign that double-double cannot tell is
/// taken exactly, and the time is within 2^-70 of itself.
Enclosure<DoubleDouble> enclose(const DoubleDouble3& r, const DoubleDouble3& v, DoubleDouble contact_distance,
                                const SphereInputError& error = {});

/// Errors of height, rate and acceleration, as for spheres.
struct PlaneInputError {
    double h = 0, w = 0, g = 0;

    bool any() const { return h > 0 || w > 0 || g > 0; }
};

/// A sphere and a plane: the first t >= 0 at which h + w t + g t^2/2 <= 0 and falls. h <= 0 with w < 0 is now; with w >
/// 0 > g it is the return, or the apex of a path that stays inside. If only the sign of h is open, the answer is still
/// certain: w < 0 arrives at once or very soon, w > 0 has just left.
Enclosure<double> enclose_plane(double h, double w, double g, const PlaneInputError& error = {});
Enclosure<DoubleDouble> enclose_plane(DoubleDouble h, DoubleDouble w, DoubleDouble g,
                                      const PlaneInputError& error = {});

}  // namespace carom
