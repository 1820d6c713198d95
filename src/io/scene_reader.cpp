#include <carom/io.hpp>
#include <filesystem>

#include "io/assign.hpp"
#include "io/limits.hpp"
#include "io/scene_draft.hpp"

namespace carom {

namespace io {

namespace {

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

/// A number t is {0, t}: what the clock shows is split into epochs by whoever wants to.
EpochTime read_start_time(ObjectView& root)
{
    EpochTime start;
    const auto place = root.find("start_time");
    if (!place) return start;
    if (place->value->kind != Json::Kind::object) {
        start.offset = as_number(*place, any_number, root.problems()).value_or(0);
        return start;
    }
    ObjectView view(*place, root.problems());
    view.require({"epoch"});
    start.epoch = static_cast<std::int64_t>(view.integer("epoch", 0, most_epochs).value_or(0));
    start.offset = view.number("offset", not_negative).value_or(0);
    view.finish();
    return start;
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
    scene.drag = root.number("drag", not_negative).value_or(scene.drag);
    scene.origin = root.vector("origin").value_or(scene.origin);
    scene.start_time = read_start_time(root);
    scene.end_time = root.number("end_time", positive).value_or(1);
    scene.seed = root.integer("seed", 0, ~std::uint64_t{0}).value_or(scene.seed);
}

void refuse_what_comes_later(ObjectView& root)
{
    root.not_yet("obstacles", never);
    root.not_yet("state", never);
}

}  // namespace

}  // namespace io

Scene parse_scene(std::string_view text, const std::string& file, const ReadOptions& options)
{
    io::SceneDraft draft;
    draft.patience = Patience(options.on_progress);
    draft.patience.begin("scene file", 1);
    io::Json json = io::parse_json(text, file, draft.patience);
    io::Problems problems(file);
    for (const std::string& assignment : options.set) io::assign(json, assignment, problems);
    problems.throw_if_any();
    io::ObjectView root({&json, ""}, problems);
    problems.throw_if_any();
    io::read_header(root, file, draft.scene);
    if (options.seed) draft.scene.seed = *options.seed;
    io::read_materials(root, draft);
    io::read_contacts(root, draft);
    io::read_rest(root, draft);
    io::read_impact(root, draft);
    io::read_guard(root, draft);
    io::read_spheres(root, draft);
    io::read_planes(root, draft);
    io::read_box(root, draft);
    io::read_fills(root, draft);
    if (draft.patience.ended()) throw Stopped();
    io::read_checks(root, draft);
    io::read_stress(root, draft);
    io::read_command_defaults(root, draft);
    io::refuse_what_comes_later(root);
    root.finish();
    problems.add_lines(validate(draft.scene, options.allow_overlap, draft.places, draft.patience));
    if (draft.patience.ended()) throw Stopped();
    problems.throw_if_any();
    return std::move(draft.scene);
}

}  // namespace carom
