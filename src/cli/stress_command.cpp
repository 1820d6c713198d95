#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/session.hpp"
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

double seconds_of_runs(const stress::Report& report)
{
    double sum = 0;
    for (const stress::Case& c : report.cases)
        for (const stress::Result& each : c.results) sum += each.seconds;
    return sum;
}

}  // namespace

int do_stress(const StressArguments& args, const GlobalArguments& global, const Console& console)
{
    Session session(args.given, global, console);
    const CommandDefaults none;
    const std::vector<std::string> methods = Choices(args.given, none, "").methods("methods", {});
    const stress::Report report = stress::run_cases(chosen_cases(args.only), methods, session.on_progress());
    session.progress.clear();

    const io::CommandFacts facts = session.watch.facts();
    const std::string json = io::stress_json(report, facts);
    if (!args.out.empty()) {
        const std::filesystem::path folder = args.out;
        write_file(folder / "stress.csv", io::stress_csv(report));
        write_file(folder / "stress.json", json);
    }
    console.out << (global.json ? json : stress_table(report));
    if (!global.json) console.out << "Clock: " << clock_text(facts, seconds_of_runs(report), "the runs") << '\n';
    if (!args.out.empty() && !global.json)
        for (const char* each : {"stress.csv", "stress.json"})
            console.out << (std::filesystem::path(args.out) / each).string() << '\n';
    if (facts.stopped && !global.quiet) print_error(console, session.watch.reason());
    if (facts.stopped == Status::interrupted) return exit_interrupted;
    if (!report.event_passes()) return exit_check_failed;
    return facts.stopped ? exit_limit : exit_ok;
}

}  // namespace carom::cli
