#include <cmath>
#include <iterator>

#include "core/text.hpp"
#include "io/limits.hpp"
#include "io/scene_draft.hpp"

namespace carom::io {

namespace {

RadiusSpec read_radius(ObjectView& view)
{
    const auto place = view.find("radius");
    if (!place) return 1.0;  // reported as missing
    if (place->value->kind != Json::Kind::object) return as_number(*place, positive, view.problems()).value_or(1);
    ObjectView spec(*place, view.problems());
    spec.one_of({"uniform", "choice"}, true);
    const bool uniform = spec.has("uniform");
    ChoiceRadius choice;
    for (const auto& entry : spec.list(uniform ? "uniform" : "choice"))
        choice.values.push_back(as_number(entry, positive, view.problems()).value_or(1));
    spec.finish();
    if (!uniform) {
        if (!choice.values.empty()) return choice;
        if (spec.has("choice")) spec.problem("choice", "must have at least one radius");
        return 1.0;
    }
    constexpr std::size_t two = 2;
    if (choice.values.size() == two && choice.values[0] <= choice.values[1])
        return UniformRadius{choice.values[0], choice.values[1]};
    spec.problem("uniform", "must be [a, b] with 0 < a <= b");
    return 1.0;
}

/// The fill's own min and max, otherwise the box.
std::optional<Region> fill_region(ObjectView& view, ObjectView& root, const SceneDraft& draft)
{
    const bool has_min = view.has("min"), has_max = view.has("max");
    if (has_min || has_max) return read_region(view);
    if (!draft.box && !root.has("box"))
        view.problems().add(view.pointer(), "has no region (give \"min\" and \"max\", or the scene a \"box\")");
    return draft.box;
}

/// Lines and triangles start at a centre and go along an axis.
template <class Rows>
Rows read_rows(ObjectView& view)
{
    Rows rows;
    rows.origin = view.vector("origin").value_or(rows.origin);
    rows.axis = read_direction(view, "axis").value_or(rows.axis);
    rows.gap = view.number("gap", not_negative).value_or(rows.gap);
    return rows;
}

std::size_t read_count(ObjectView& view)
{
    view.require({"count"});
    return static_cast<std::size_t>(view.integer("count", 1, most_spheres).value_or(1));
}

void read_triangle(ObjectView& view, FillSpec& fill)
{
    view.one_of({"rows", "count"}, true);
    const auto rows = view.integer("rows", 1, most_triangle_rows);
    const auto count = view.integer("count", 1, most_spheres);
    fill.count = static_cast<std::size_t>(rows ? *rows * (*rows + 1) / 2 : count.value_or(1));
    const auto triangle = read_rows<TrianglePattern>(view);
    if (std::sqrt(triangle.axis.head<2>().squaredNorm()) < least_axis_sine)
        view.problem("axis", "must not be along z, for the rows lie across axis x z");
    if (!std::holds_alternative<double>(fill.radius))
        view.problem("radius", "must be one number for pattern \"triangle\"");
    fill.pattern = triangle;
}

void read_pattern(ObjectView& view, ObjectView& root, const SceneDraft& draft, FillSpec& fill)
{
    const auto name = view.word("pattern", {"line", "triangle", "cubic", "random"}, {"fcc"});
    if (!name) return;
    if (*name == "triangle") return read_triangle(view, fill);
    fill.count = read_count(view);
    if (*name == "line") {
        fill.pattern = read_rows<LinePattern>(view);
        return;
    }
    const Region region = fill_region(view, root, draft).value_or(Region{});
    if (*name == "cubic")
        fill.pattern = CubicPattern{region};
    else
        fill.pattern = RandomPattern{region};
}

FillSpec read_fill(ObjectView& view, ObjectView& root, const SceneDraft& draft, std::size_t index)
{
    FillSpec fill;
    view.require({"pattern", "radius"});
    fill.id = read_id(view, "fill-" + std::to_string(index));
    fill.stream = index;
    fill.radius = read_radius(view);
    const MassSpec mass = read_mass(view);
    fill.mass = mass.mass;
    fill.density = mass.density;
    fill.velocity = view.vector("velocity").value_or(fill.velocity);
    fill.speed = view.number("speed", not_negative).value_or(0);
    fill.fixed = view.boolean("fixed").value_or(false);
    if (fill.fixed && fill.velocity != Vec3::Zero()) view.problem("velocity", "must be 0, for the spheres are fixed");
    if (fill.fixed && fill.speed != 0) view.problem("speed", "must be 0, for the spheres are fixed");
    fill.material = read_material(view, draft);
    fill.color = read_color(view);
    view.not_yet("temperature", [](const Json&) { return false; });
    read_pattern(view, root, draft, fill);
    const bool pattern_known = fill.count > 0;  // otherwise nobody knows which keys it may have
    if (pattern_known) view.finish();
    return fill;
}

void add_spheres(std::vector<Sphere> spheres, const std::string& pointer, SceneDraft& draft)
{
    std::vector<Sphere>& all = draft.scene.spheres;
    draft.places.spheres.resize(all.size() + spheres.size(), pointer);
    if (all.empty())
        all = std::move(spheres);
    else
        all.insert(all.end(), std::move_iterator(spheres.begin()), std::move_iterator(spheres.end()));
}

}  // namespace

void read_fills(ObjectView& root, SceneDraft& draft)
{
    Problems& problems = root.problems();
    std::size_t index = 0;
    for (const auto& place : root.list("fill")) {
        const std::size_t before = problems.count();
        ObjectView view(place, problems);
        const FillSpec fill = read_fill(view, root, draft, index++);
        if (draft.scene.spheres.size() + fill.count > most_spheres)
            view.problem("count", "makes more than " + std::to_string(most_spheres) + " spheres (take fewer)");
        const bool box_is_missing = !draft.box && root.has("box");
        if (problems.count() != before || box_is_missing) {
            draft.bodies_complete = false;
            continue;
        }
        draft.patience.begin(fill.id, static_cast<double>(fill.count), "spheres");
        Filled filled = expand_fill(fill, draft.scene, draft.patience);
        if (draft.patience.ended()) return;
        if (!filled.problem.empty()) {
            problems.add_lines({place.pointer + filled.problem});
            draft.bodies_complete = false;
        }
        add_spheres(std::move(filled.spheres), place.pointer, draft);
    }
}

}  // namespace carom::io
