#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/page_files.hpp"
#include "cli/session.hpp"
#include "cli/tables.hpp"
#include "io/problems.hpp"
#include "io/stress_files.hpp"
#include "io/stress_scenes.hpp"
#include "report/page.hpp"
#include "report/stress_page.hpp"

#include <carom/io.hpp>

#include <algorithm>
#include <ostream>

namespace carom::cli {

namespace {

/// None if the command ended before they were read.
std::vector<stress::Case> read_cases(Session& session)
{
    try {
        return stress::cases_of(io::read_stress_scenes(scene_folder() / "stress", session.on_progress()));
    } catch (const Stopped&) {
        return {};
    }
}

/// Cases of the names given, or all.
void keep_only(std::vector<stress::Case>& cases, const std::vector<std::string>& only)
{
    std::vector<std::string> names;
    for (const stress::Case& each : cases) names.push_back(each.words.case_name);
    const auto holds = [](const auto& list, const std::string& name) {
        return std::ranges::find(list, name) != list.end();
    };
    for (const std::string& each : only)
        if (!holds(names, each))
            throw UsageError("unknown case \"" + each + "\"" + io::suggestion(each, names, "there are"));
    if (!only.empty()) std::erase_if(cases, [&](const stress::Case& c) { return !holds(only, c.words.case_name); });
}

}  // namespace

int do_stress(const StressArguments& args, const GlobalArguments& global, const Console& console)
{
    Session session(args.given, global, console);
    const CommandDefaults none;
    const auto who = stress::contestants(Choices(args.given, none, "").methods("methods", {}));
    std::vector<stress::Case> cases = read_cases(session);
    if (!session.watch.ended()) keep_only(cases, args.only);
    if (args.list) {
        session.progress.clear();
        const stress::Report all{.methods = {}, .cases = std::move(cases)};
        console.out << (global.json ? io::stress_json(all) : stress_table(all));
        return exit_ok;
    }
    const stress::Report report = stress::run_cases(std::move(cases), who, session.on_progress());
    session.progress.clear();

    const io::CommandFacts facts = session.watch.facts();
    const std::string json = io::stress_json(report, facts);
    const std::filesystem::path folder = args.out;
    const std::vector<std::pair<std::string, std::string>> files{
        {"stress.csv", io::stress_csv(report)},
        {"stress.json", json},
        {"report.html", comparison_page(report::stress_page_data(report, json, page_generator()))}};
    console.out << (global.json ? json : stress_table(report));
    if (!global.json) console.out << "Clock: " << clock_text(facts, facts.cpu_seconds, "the runs") << '\n';
    for (const auto& [name, text] : files) {
        if (args.out.empty()) continue;
        write_file(folder / name, text);
        if (!global.json) console.out << (folder / name).string() << '\n';
    }
    if (facts.stopped && !global.quiet) print_error(console, session.watch.reason());
    if (facts.stopped == Status::interrupted) return exit_interrupted;
    if (!report.exact_hold()) return exit_check_failed;
    return facts.stopped ? exit_limit : exit_ok;
}

}  // namespace carom::cli
