#include <algorithm>
#include <array>

#include "io/scene_draft.hpp"

namespace carom::io {

namespace {

const std::vector<std::string>& side_names()
{
    static const std::vector<std::string> names{"-x", "+x", "-y", "+y", "-z", "+z"};
    return names;
}

void check_walls(ObjectView& view)
{
    const auto walls = view.find("walls");
    if (!walls) return;
    constexpr std::size_t axes = 3;
    const std::vector<std::string> now{"solid"}, later{"periodic"};
    if (walls->value->kind != Json::Kind::array) {
        as_word(*walls, now, later, view.problems());
        return;
    }
    for (const auto& place : as_list(*walls, view.problems())) as_word(place, now, later, view.problems());
    if (walls->value->items.size() != axes) view.problem("walls", "must have one entry for each of the 3 axes");
}

/// Wall of side 0..5 with its normal to the inside.
Plane wall(std::size_t side, const Region& region, int material)
{
    const auto axis = static_cast<Eigen::Index>(side / 2);
    const bool upper = side % 2 == 1;
    Plane p;
    p.id = "box" + side_names()[side];
    p.normal = Vec3::Zero();
    p.normal[axis] = upper ? -1 : 1;
    p.offset = upper ? -region.max[axis] : region.min[axis];
    p.material = material;
    return p;
}

}  // namespace

void read_box(ObjectView& root, SceneDraft& draft)
{
    const auto section = root.find("box");
    if (!section) return;
    const std::size_t before = root.problems().count();
    ObjectView view(*section, root.problems());
    const auto region = read_region(view);
    check_walls(view);
    std::vector<std::string> open;
    for (const auto& place : view.list("open"))
        if (auto side = as_word(place, side_names(), {}, root.problems())) open.push_back(*std::move(side));
    const int material = read_material(view, draft);
    view.finish();
    if (root.problems().count() != before || !region) {
        draft.bodies_complete = false;
        return;
    }
    draft.box = region;
    for (std::size_t side = 0; side < side_names().size(); ++side) {
        if (std::find(open.begin(), open.end(), side_names()[side]) != open.end()) continue;
        draft.scene.planes.push_back(wall(side, *region, material));
        draft.places.planes.push_back(section->pointer);
    }
}

}  // namespace carom::io
