/// \file
/// A scene while it is being read, and the sections of the file, one reader each.
#pragma once

#include <carom/scene.hpp>
#include <optional>
#include <string>

#include "io/object_view.hpp"
#include "scene/fill.hpp"
#include "scene/validate.hpp"

namespace carom::io {

/// Wrong parts are left out of the scene (and reported), so that the rest can still be validated.
struct SceneDraft {
    Scene scene;
    BodyPlaces places;            ///< of the bodies read so far
    bool bodies_complete = true;  ///< false once a body had to be left out
    std::optional<Region> box;    ///< where fills go that name no region
    Patience patience;            ///< once it has ended, nothing here is complete
};

// scene_materials.cpp
void read_materials(ObjectView& root, SceneDraft& draft);
void read_contacts(ObjectView& root, SceneDraft& draft);
// scene_rest.cpp
void read_rest(ObjectView& root, SceneDraft& draft);
// scene_impact.cpp
void read_impact(ObjectView& root, SceneDraft& draft);
// scene_guard.cpp
void read_guard(ObjectView& root, SceneDraft& draft);
// scene_spheres.cpp
void read_spheres(ObjectView& root, SceneDraft& draft);
// scene_planes.cpp
void read_planes(ObjectView& root, SceneDraft& draft);
// scene_box.cpp
void read_box(ObjectView& root, SceneDraft& draft);
// scene_fills.cpp: after everything that fills must avoid
void read_fills(ObjectView& root, SceneDraft& draft);
// scene_checks.cpp: after all bodies
void read_checks(ObjectView& root, SceneDraft& draft);
// scene_stress.cpp
void read_stress(ObjectView& root, SceneDraft& draft);
// scene_defaults.cpp
void read_command_defaults(ObjectView& root, SceneDraft& draft);

// scene_parts.cpp: what several sections share
/// Index of the material that a value names.
std::optional<int> as_material(const Place& place, const Scene& scene, Problems& problems);
/// Index by the key "material"; without it the material "default", index 0.
int read_material(ObjectView& view, const SceneDraft& draft);
/// An id that may stand in a table: not empty, no commas, quotes or control characters.
std::string read_id(ObjectView& view, const std::string& fallback);
std::string read_color(ObjectView& view);
/// A vector of any length > 0 as a unit vector.
std::optional<Vec3> read_direction(ObjectView& view, std::string_view key);
/// min < max on each axis.
std::optional<Region> read_region(ObjectView& view);

struct MassSpec {
    double mass = 1;
    std::optional<double> density;
};
MassSpec read_mass(ObjectView& view);

}  // namespace carom::io
