/// \file
/// Two spheres under different accelerations, decided exactly: the gap function F = |p|^2 - S^2 is a quartic in time.
#pragma once

#include "toi/enclosure.hpp"

namespace carom {

/// Relative motion r + v t + a t^2/2 from a common time, taken exactly; a is not 0.
struct ExactMotion {
    DoubleDouble3 r, v, a;
    DoubleDouble contact_distance;
};

/// First t >= 0 at which |p(t)| <= S and the distance shrinks; `pressed` as for planes. No answer is ambiguous, and
/// t_lo and t_hi are neighbouring doubles (or one): H = F'/2 is cut into monotone pieces by the roots of H', F by the
/// roots of H, and every sign is exact, at doubles as at roots that are none. Method: this project, with Sturm's
/// theorem where a sign is asked at a root. Some 50 us.
Enclosure<double> enclose_accelerated(const ExactMotion& motion);

}  // namespace carom
