/// \file
/// When the gap of two bodies turns while drag damps their flights.
#pragma once

#include "stepping/path_contacts.hpp"

#include <vector>

namespace carom::stepping {

/// Times from `now` to the end of the substep at which the rate of the gap changes its sign, since `now`, rising. At a
/// plane, and between spheres with one acceleration, the rate is linear in s (damped_times.hpp): there is one at most.
/// Between others the rest of the substep is halved until, by Taylor's formula of second order with a bound of its
/// remainder, the rate keeps its sign in a piece or is monotone there; only turns that come in twos within 2^-40 of it
/// may be left out.
/// \pre the paths are damped, both have reached `now`
std::vector<double> damped_turns(System& system, const PathContacts& contacts, BodyId a, BodyId b, double now);

}  // namespace carom::stepping
