#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
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

}  // namespace

int do_stress(const StressArguments& args, const GlobalArguments& global, const Console& console)
{
    stress::Options options = stress_settings(args);
    const InterruptGuard guard;
    ProgressLine progress(console, global);
    options.on_progress = [&](const std::string& what, double fraction) {
        progress.show(what, fraction);
        return !guard.interrupted();
    };
    const stress::Report report = stress::run_cases(options);
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
