/// \file
/// Numbers that the engine's arithmetic has room for.
#pragma once

#include <carom/scene.hpp>

#include <string>

namespace carom {

/// The reason why the scene cannot be run until `until` [time]: numbers on the way would leave the range of doubles, or
/// times and places that of the frame's epochs and cells. Empty if it can. Lengths, masses, speeds and accelerations
/// may be up to 2^400 in size, also the speed that the lightest sphere would have with all the energy; radii and masses
/// down to 2^-400, gravity down to 2^-1000 or 0. \pre the scene is valid
std::string out_of_range(const Scene& scene, double until);

/// Whether some sphere might get so far from the others until `until` that lists of neighbours would lose digits. \pre
/// the scene is in range
bool goes_far(const Scene& scene, double until);

}  // namespace carom
