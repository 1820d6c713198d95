/// \file
/// The judgement of one throw, by the definitions of the one-step audit of `compare`.
#pragma once

#include "tunnel/contestant.hpp"

namespace carom::tunnel {

enum class Fate : std::uint8_t {
    hit,       ///< answered in the step of the contact, and the velocity after two steps is right to 1 % of |dv|
    wrong,     ///< answered, but late or with another velocity; exact methods: not to 1e-9
    tunnelled  ///< not answered within two steps, or behind the plate at last
};

struct Judgement {
    Fate fate = Fate::hit;
    double error = 0;  ///< distance from the true place two steps after the begin [length]
};

Judgement judge(const Contestant& who, const Throw& t, double dt);

}  // namespace carom::tunnel
