/// \file
/// How near two spheres come in a time interval in which neither changes its flight.
#pragma once

#include "verify/path.hpp"

namespace carom::verification {

/// Knowledge of a flight, the best first.
enum class Grade : std::uint8_t {
    exact,          ///< gap >= min(0, initial gap)
    bounded,        ///< gap >= -b
    in_contact,     ///< gap >= -1e-9 r, of what persistent contacts hold
    measured,       ///< gap >= a bound that is measured, of what no closed form gives
    not_certified,  ///< neither shown nor refuted
    violated        ///< gap < -b
};

/// Two flights, the interval, and the distance at which they touch.
struct PairSegment {
    const Path &a, &b;
    const Vec3 &acceleration_a, &acceleration_b;  ///< [cells/epoch^2]
    EpochTime from, to;
    double radius_a, radius_b;  ///< [cells]
    /// Flights at the start of a pair that overlapped then. The initial distance takes the place of the sum of
    /// radii.
    const Path *initial_a = nullptr, *initial_b = nullptr;
};

/// How small a quantity gets: not below value - error, and `value` is the best estimate.
struct Least {
    double value = 0, error = 0;
    bool at_start = true;  ///< where, roughly
    bool open = false;     ///< could not be bounded: no statement
};

enum class Level : std::uint8_t { plain, double_double, exact };

struct GapFound {
    Grade grade = Grade::exact;
    Level level = Level::plain;  ///< that decided
    double gap = 0;              ///< smallest, if `measured` [cells]
    bool measured = false;       ///< the gap was worth measuring: it may be the smallest of the run
    bool at_start = true;
};

/// A quick look in double: is the gap certainly larger than 0 and than `smallest` throughout? [cells]
bool is_clear(const PairSegment& segment, double smallest);
/// The careful one. \param bound so much may be missing of the gap that is needed [cells]
GapFound examine(const PairSegment& segment, double bound);

/// S^2, and the size beside which its error is a rounding.
template <class N>
struct Contact {
    N square;
    double size;
};

/// |r|^2 - S^2 under unequal accelerations, by intervals. Used by `examine`.
template <class N>
Least least_accelerated(const PairSegment& segment, const Contact<N>& contact);

}  // namespace carom::verification
