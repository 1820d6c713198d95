/// \file
/// The world of a scene for other bodies than its own.
#pragma once

#include <carom/scene.hpp>

namespace carom {

/// Field, place, clock, laws and thresholds of a scene: units, gravity, drag, origin, start_time, end_time, seed,
/// materials, contacts, rest, impact, guard. What speaks of its bodies is left out: name and description, spheres,
/// planes, checks, its part in `carom stress`, defaults of commands.
Scene without_bodies(const Scene& scene);

}  // namespace carom
