/// \file
/// The first contact of two bodies on their paths within a substep, as a root.
#pragma once

#include "stepping/path_contacts.hpp"

#include <optional>

namespace carom::stepping {

/// The first time from `now` to the end of the substep at which the gap is closed and shrinks: the last double at which
/// it is still open, or where a gap that is closed already begins to shrink. Nothing if there is none.
///
/// The gap is cut where it turns, at roots of its rate: of degree 1 at a plane and between spheres with one
/// acceleration, of degree 3 between others; with drag by damped_turns.hpp. A piece on which it shrinks holds one
/// contact at most, which is bisected. Only contacts that graze by less than rounding may be missed or invented. \pre
/// both have reached `now`
std::optional<double> first_contact(System& system, const PathContacts& contacts, BodyId a, BodyId b, double now);

}  // namespace carom::stepping
