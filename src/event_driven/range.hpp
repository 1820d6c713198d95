/// \file
/// Numbers that the engine's arithmetic has room for.
#pragma once

#include <carom/scene.hpp>

#include <string>

namespace carom {

/// What in the scene is so large or so small that squares and products on the way would leave the range of doubles;
/// empty if nothing is. Lengths, masses, speeds and accelerations may be up to 2^400 in size, also the speed that the
/// lightest sphere would have with all the energy; radii and masses down to 2^-400. \pre the scene is valid
std::string out_of_range(const Scene& scene);

}  // namespace carom
