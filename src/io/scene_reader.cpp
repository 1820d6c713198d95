#include <carom/io.hpp>
#include <filesystem>

#include "core/text.hpp"
#include "io/scene_draft.hpp"

namespace carom {

namespace io {

namespace {

bool is_zero(const Json& json)
{
    return json.kind == Json::Kind::number && json.number == 0;
}

bool is_zero_vector(const Json& json)
{
    for (const auto& item : json.items)
        if (!is_zero(item)) return false;
    return json.kind == Json::Kind::array && json.items.size() == 3;
}

bool is_empty_list(const Json& json)
{
    return json.kind == Json::Kind::array && json.items.empty();
}

bool never(const Json&)
{
    return false;
}

Units read_units(ObjectView& root)
{
    Units units;
    const auto section = root.find("units");
    if (!section) return units;
    ObjectView view(*section, root.problems());
    units.length = view.string("length").value_or("");
    units.time = view.string("time").value_or("");
    units.mass = view.string("mass").value_or("");
    view.finish();
    return units;
}

void read_header(ObjectView& root, const std::string& file, Scene& scene)
{
    root.find("$schema");
    root.require({"format", "end_time"});
    root.word("format", {"carom-scene/1"});
    scene.name = root.string("name").value_or(std::filesystem::path(file).stem().string());
    scene.description = root.string("description").value_or("");
    scene.units = read_units(root);
    scene.gravity = root.vector("gravity").value_or(scene.gravity);
    scene.end_time = root.number("end_time", positive).value_or(1);
    scene.seed = root.integer("seed", 0, ~std::uint64_t{0}).value_or(scene.seed);
}

void refuse_what_comes_later(ObjectView& root)
{
    root.not_yet("origin", is_zero_vector);
    root.not_yet("start_time", is_zero);
    root.not_yet("drag", is_zero);
    root.not_yet("obstacles", is_empty_list);
    root.not_yet("impact", never);
    root.not_yet("guard", never);
    root.not_yet("state", never);
}

}  // namespace

}  // namespace io

Scene parse_scene(std::string_view text, const std::string& file, const ReadOptions& options)
{
    const io::Json json = io::parse_json(text, file);
    io::Problems problems(file);
    io::ObjectView root({&json, ""}, problems);
    problems.throw_if_any();
    io::SceneDraft draft;
    io::read_header(root, file, draft.scene);
    if (options.seed) draft.scene.seed = *options.seed;
    io::read_materials(root, draft);
    io::read_contacts(root, draft);
    io::read_rest(root, draft);
    io::read_spheres(root, draft);
    io::read_planes(root, draft);
    io::read_box(root, draft);
    io::read_fills(root, draft);
    io::read_checks(root, draft);
    io::read_command_defaults(root, draft);
    io::refuse_what_comes_later(root);
    root.finish();
    problems.add_lines(validate(draft.scene, options.allow_overlap, draft.places));
    problems.throw_if_any();
    return std::move(draft.scene);
}

}  // namespace carom
