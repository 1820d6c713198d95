#include "io/limits.hpp"
#include "io/scene_draft.hpp"

namespace carom::io {

namespace {

Sphere read_sphere(ObjectView& view, std::size_t index, const SceneDraft& draft)
{
    Sphere s;
    view.require({"radius", "position"});
    s.id = read_id(view, "sphere-" + std::to_string(index));
    s.radius = view.number("radius", positive).value_or(1);
    const MassSpec mass = read_mass(view);
    s.mass = mass.density ? sphere_mass(*mass.density, s.radius) : mass.mass;
    s.position = view.vector("position").value_or(s.position);
    s.velocity = view.vector("velocity").value_or(s.velocity);
    s.material = read_material(view, draft);
    s.color = read_color(view);
    s.fixed = view.boolean("fixed").value_or(false);
    if (s.fixed && s.velocity != Vec3::Zero()) view.problem("velocity", "must be 0, for the sphere is fixed");
    view.finish();
    return s;
}

}  // namespace

void read_spheres(ObjectView& root, SceneDraft& draft)
{
    std::size_t index = 0;
    const auto places = root.list("spheres");
    draft.patience.begin("spheres", static_cast<double>(places.size()), "spheres");
    for (const auto& place : places) {
        if (!draft.patience.lasts_for(work_of_a_sphere)) return;
        draft.patience.reach(static_cast<double>(index));
        const std::size_t before = root.problems().count();
        ObjectView view(place, root.problems());
        Sphere sphere = read_sphere(view, index++, draft);
        if (root.problems().count() != before) {
            draft.bodies_complete = false;
            continue;
        }
        draft.scene.spheres.push_back(std::move(sphere));
        draft.places.spheres.push_back(place.pointer);
    }
}

}  // namespace carom::io
