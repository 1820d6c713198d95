#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/session.hpp"
#include "cli/tables.hpp"
#include "io/stress_files.hpp"
#include "study/stress/stress.hpp"

#include <carom/error.hpp>

#include <ostream>

namespace carom::cli {

namespace {

stress::Options stress_settings(const StressArguments& args)
{
    stress::Options options;
    const CommandDefaults none;
    options.methods = Choices(args.given, none, "").methods("methods", {});
    if (args.only.empty()) return options;
    options.only = args.only;
    std::string known;
    for (const std::string& each : stress::case_names()) {
        if (each == args.only) return options;
        known += (known.empty() ? "" : ", ") + each;
    }
    throw UsageError("--case: unknown case \"" + args.only + "\" (take " + known + ")");
}

double seconds_of_runs(const stress::Report& report)
{
    double sum = 0;
    for (const stress::CaseResult& c : report.cases)
        for (const stress::Result& each : c.results) sum += each.seconds;
    return sum;
}

}  // namespace

int do_stress(const StressArguments& args, const GlobalArguments& global, const Console& console)
{
    Session session(args.given, global, console);
    stress::Options options = stress_settings(args);
    options.on_progress = session.on_progress();
    const stress::Report report = stress::run_cases(options);
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
