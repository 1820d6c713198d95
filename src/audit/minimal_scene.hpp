/// \file
/// The smallest scene that shows a finding: the bodies concerned, as the frames before it have them.
#pragma once

#include "audit/report.hpp"

#include <carom/scene.hpp>

namespace carom::audit {

/// Its checks say what a correct run shows: the time of the touch, or that there is no contact. The event method holds
/// them. A scene of bodies that overlap in the first frame must be read with overlap allowed.
Scene minimal_scene(const Scene& scene, const Finding& finding);

}  // namespace carom::audit
