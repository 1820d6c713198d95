#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "io/stress_files.hpp"
#include "study/stress.hpp"

#include <carom/error.hpp>
#include <carom/io.hpp>

#include <fmt/format.h>

#include <ostream>

namespace carom::cli {

namespace {

std::vector<Scene> stress_scenes()
{
    std::vector<Scene> scenes;
    for (const std::filesystem::path& file : scene_files(scene_folder() / "stress"))
        if (Scene scene = read_scene(file); scene.stress) scenes.push_back(std::move(scene));
    return scenes;
}

/// All cases, or the one asked for.
std::vector<stress::Case> chosen_cases(const std::string& only)
{
    std::vector<stress::Case> cases = stress::cases_of(stress_scenes());
    if (only.empty()) return cases;
    std::vector<std::string> names;
    for (const stress::Case& each : cases) names.push_back(each.words.case_name);
    std::erase_if(cases, [&](const stress::Case& each) { return each.words.case_name != only; });
    if (cases.empty())
        throw UsageError(fmt::format("--case: unknown case \"{}\" (take {})", only, fmt::join(names, ", ")));
    return cases;
}

}  // namespace

int do_stress(const StressArguments& args, const GlobalArguments& global, const Console& console)
{
    const CommandDefaults none;
    const std::vector<std::string> methods = Choices(args.given, none, "").methods("methods", {});
    std::vector<stress::Case> cases = chosen_cases(args.only);
    const InterruptGuard guard;
    ProgressLine progress(console, global);
    const stress::Report report =
        stress::run_cases(std::move(cases), methods, [&](const std::string& what, double fraction) {
            progress.show(what, fraction);
            return !guard.interrupted();
        });
    progress.clear();

    const std::string json = io::stress_json(report);
    if (!args.out.empty()) {
        const std::filesystem::path folder = args.out;
        write_file(folder / "stress.csv", io::stress_csv(report));
        write_file(folder / "stress.json", json);
    }
    console.out << (global.json ? json : stress_table(report));
    if (!args.out.empty() && !global.json)
        for (const char* each : {"stress.csv", "stress.json"})
            console.out << (std::filesystem::path(args.out) / each).string() << '\n';
    if (report.interrupted) return exit_interrupted;
    return report.event_passes() ? exit_ok : exit_check_failed;
}

}  // namespace carom::cli
