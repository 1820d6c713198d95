/// \file
/// Lists of pairs that are near each other, for windows: they last for several.
#pragma once

#include "gather/may_touch.hpp"
#include "motion/moment.hpp"
#include "motion/window_piece.hpp"

namespace carom {

/// Whether a body takes part in windows as one that nothing moves: fixed, or at rest in several contacts and not to be
/// woken.
using StandsStill = std::function<bool(BodyId)>;

/// All pairs with gaps below the skin of the bodies that such pairs connect with `seeds`, through bodies that move.
/// \param wide every sphere whose surface may be less than the skin away
std::shared_ptr<const NearPairs> list_near(const State& state, Moment& moment, const std::vector<BodyId>& seeds,
                                           double skin, const StandsStill& stands_still, const Neighbourhood& wide);

/// Largest gap up to which `wide` shows every pair [length].
double widest_skin(const State& state);

}  // namespace carom
