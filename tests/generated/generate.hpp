/// \file
/// Scenes drawn at random that are hard on an engine that resolves several contacts at once.
#pragma once

#include <carom/scene.hpp>

#include <cstdint>
#include <string>

namespace carom::test {

struct GeneratedScene {
    std::string kind;  ///< dense, inelastic, inclined, cornered, touching, tiny_gaps, mass_ratios, mixed
    Scene scene;       ///< valid
};

/// Scene `index` of a series: kinds in turn, everything else from (seed, index). 2 time units long, 2 to 40 spheres,
/// some contacts with e < 1; walls or bowls from which nothing can get away.
GeneratedScene generate_scene(std::uint64_t seed, std::uint64_t index);

}  // namespace carom::test
