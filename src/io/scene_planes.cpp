#include "io/scene_draft.hpp"

namespace carom::io {

namespace {

Plane read_plane(ObjectView& view, std::size_t index, const SceneDraft& draft)
{
    Plane p;
    view.require({"normal"});
    p.id = read_id(view, "plane-" + std::to_string(index));
    p.normal = read_direction(view, "normal").value_or(p.normal);
    view.one_of({"offset", "point"}, true);
    p.offset = view.number("offset").value_or(0);
    if (const auto point = view.vector("point")) p.offset = p.normal.dot(*point);
    p.thickness = view.number("thickness", not_negative);
    p.material = read_material(view, draft);
    view.never({"angle", "slope", "tilt", "degrees", "inclination"},
               "for a slope of a degrees write \"normal\": [sin a, 0, cos a] as numbers");
    view.finish();
    return p;
}

}  // namespace

void read_planes(ObjectView& root, SceneDraft& draft)
{
    std::size_t index = 0;
    for (const auto& place : root.list("planes")) {
        const std::size_t before = root.problems().count();
        ObjectView view(place, root.problems());
        Plane plane = read_plane(view, index++, draft);
        if (root.problems().count() != before) {
            draft.bodies_complete = false;
            continue;
        }
        draft.scene.planes.push_back(std::move(plane));
        draft.places.planes.push_back(place.pointer);
    }
}

}  // namespace carom::io
