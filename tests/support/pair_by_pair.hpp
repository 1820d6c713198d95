/// \file
/// Bodies in a row that touch, whose neighbours collide one pair after the other, in 60 digits: an oracle of its own
/// for impacts of several contacts, for it shares nothing with the engine.
#pragma once

#include "support/multiprecision.hpp"

#include <cstdint>
#include <vector>

namespace carom::test {

using Float60 = Float<60>;

struct PairByPair {
    std::vector<Float60> velocities;
    std::int64_t impacts = 0;
};

/// Velocities along the row after impacts with restitution e, from left to right again and again, until no pair closes
/// faster than 1e-40. \param masses,velocities from left to right
inline PairByPair pair_by_pair(const std::vector<Float60>& masses, std::vector<Float60> velocities, const Float60& e)
{
    const Float60 least("1e-40");
    PairByPair out;
    for (bool closes = true; closes;) {
        closes = false;
        for (std::size_t i = 0; i + 1 < masses.size(); ++i) {
            const Float60 closing = velocities[i] - velocities[i + 1];
            if (closing <= least) continue;
            closes = true;
            ++out.impacts;
            const Float60 impulse = (1 + e) * closing / (1 / masses[i] + 1 / masses[i + 1]);
            velocities[i] -= impulse / masses[i];
            velocities[i + 1] += impulse / masses[i + 1];
        }
    }
    out.velocities = std::move(velocities);
    return out;
}

/// The velocity that all have when they stick together.
inline Float60 together(const std::vector<Float60>& masses, const std::vector<Float60>& velocities)
{
    Float60 momentum = 0, mass = 0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        momentum += masses[i] * velocities[i];
        mass += masses[i];
    }
    return momentum / mass;
}

}  // namespace carom::test
