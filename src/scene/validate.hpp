/// \file
/// Rules that a scene must keep, beyond the types of its fields.
#pragma once

#include <carom/scene.hpp>

#include <string>
#include <vector>

namespace carom
{

/// Every broken rule as "/json/pointer: what is wrong (the cure)"; empty when the scene is valid. Values first (finite,
/// in range); if those hold, overlaps.
std::vector<std::string> validate(const Scene& scene, bool allow_overlap = false);

}  // namespace carom
