#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/tables.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <ostream>

namespace carom::cli {

namespace {

using Json = nlohmann::ordered_json;

void list(const GlobalArguments& global, const Console& console)
{
    const std::vector<CatalogueEntry> entries = list_scenes(scene_folder());
    Json json = {{"format", "carom-scenes/1"}, {"scenes", Json::array()}};
    std::vector<std::vector<std::string>> lines;
    for (const CatalogueEntry& each : entries) {
        lines.push_back({each.name, each.title});
        json["scenes"].push_back({{"name", each.name},
                                  {"title", each.title},
                                  {"description", each.description},
                                  {"path", each.path.string()}});
    }
    if (global.json)
        console.out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    else
        console.out << aligned(lines, 2);
    if (entries.empty() && !global.quiet) print_error(console, "no scenes in " + scene_folder().string());
}

void show(const std::string& what, const GlobalArguments& global, const Console& console)
{
    const std::filesystem::path file = find_scene(what, scene_folder());
    const Scene scene = read_scene(file);
    if (global.json) {
        console.out << read_file(file);  // the scene file is the JSON object
        return;
    }
    std::vector<std::vector<std::string>> lines{{"scene", scene.name}, {"file", file.string()}};
    if (!scene.description.empty()) lines.push_back({"about", scene.description});
    lines.push_back({"spheres", std::to_string(scene.spheres.size())});
    std::string planes = std::to_string(scene.planes.size());
    for (const Plane& plane : scene.planes) planes += (&plane == &scene.planes.front() ? ": " : ", ") + plane.id;
    lines.push_back({"planes", planes});
    lines.push_back({"gravity", fmt::format("{} {} {}", scene.gravity[0], scene.gravity[1], scene.gravity[2])});
    if (scene.drag > 0) lines.push_back({"drag", fmt::format("{}", scene.drag)});
    lines.push_back(
        {"end time", fmt::format("{}{}{}", scene.end_time, scene.units.time.empty() ? "" : " ", scene.units.time)});
    lines.push_back({"checks", std::to_string(scene.checks.size())});
    console.out << aligned(lines, 2);
}

/// Problems of each scene. Those of the whole catalogue include the files that its list leaves out.
int validate(const std::vector<std::string>& wanted, const GlobalArguments& global, const Console& console)
{
    std::vector<std::filesystem::path> files;
    for (const std::string& each : wanted) files.push_back(find_scene(each, scene_folder()));
    if (wanted.empty()) files = scene_files(scene_folder());
    Json json = {{"format", "carom-validation/1"}, {"scenes", Json::array()}};
    bool all_valid = true;
    for (const std::filesystem::path& file : files) {
        std::vector<std::string> problems;
        try {
            const Scene scene = read_with_options(file, false, {}, global);
            // The defaults of commands as these will read them.
            static_cast<void>(run_settings({}, global, scene, file.string()));
            static_cast<void>(compare_settings({}, global, scene, file.string()));
        } catch (const InputError& error) {
            problems = error.problems();
        }
        all_valid = all_valid && problems.empty();
        json["scenes"].push_back({{"path", file.string()}, {"valid", problems.empty()}, {"problems", problems}});
        if (global.json) continue;
        if (problems.empty()) console.out << file.string() << ": valid\n";
        for (const std::string& problem : problems) print_error(console, problem);
    }
    if (global.json) console.out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    if (files.empty() && !global.quiet) print_error(console, "no scenes in " + scene_folder().string());
    return all_valid ? exit_ok : exit_bad_input;
}

}  // namespace

int do_scenes(const ScenesArguments& args, const GlobalArguments& global, const Console& console)
{
    switch (args.action) {
        case ScenesAction::list:
            list(global, console);
            break;
        case ScenesAction::show:
            show(args.show, global, console);
            break;
        case ScenesAction::validate:
            return validate(args.validate, global, console);
        case ScenesAction::schema:
            console.out << read_file(scene_folder() / "scene.schema.json");
            break;
    }
    return exit_ok;
}

}  // namespace carom::cli
