#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/interrupt.hpp"
#include "cli/notes.hpp"
#include "cli/page_files.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "io/compare_files.hpp"
#include "report/page_data.hpp"
#include "study/words.hpp"

#include <carom/io.hpp>

#include <ostream>

namespace carom::cli {

namespace {

/// A run that failed counts more than one that met a limit.
int worst_exit(const Comparison& comparison)
{
    int worst = exit_ok;
    for (const CompareRow& row : comparison.rows) {
        const int code = exit_code(row.status);
        if (code == exit_failed || worst == exit_ok) worst = code;
    }
    return worst;
}

void tell_what_stopped(const Comparison& comparison, const Console& console)
{
    for (const CompareRow& row : comparison.rows) {
        if (row.status == Status::reached_end) continue;
        const std::string run = row.method + (row.dt ? " at dt = " + study::step_text(*row.dt) : "");
        print_error(console, run + ": " + name(row.status) + (row.message.empty() ? "" : ": " + row.message));
        Outcome outcome;
        outcome.status = row.status;
        outcome.time = row.time;
        if (const std::string advice = unresolved_advice(outcome); !advice.empty()) print_note(console, advice);
    }
}

}  // namespace

int do_compare(const CompareArguments& args, const GlobalArguments& global, const Console& console)
{
    const std::filesystem::path file = find_scene(args.scene, scene_folder());
    const Scene scene = read_with_options(file, args.allow_overlap, args.set, global);
    CompareOptions options = compare_settings(args, global, scene, file.string());
    const std::filesystem::path folder = args.out.empty()
                                             ? std::filesystem::path("out") / ("compare-" + file.stem().string())
                                             : std::filesystem::path(args.out);

    if (!global.quiet)
        for (const std::string& each : unused_materials(scene, args.set)) print_note(console, each);

    const InterruptGuard guard;
    ProgressLine progress(console, global);
    options.on_progress = [&](const CompareProgress& now) {
        progress.show(now.what, now.fraction);
        return !guard.interrupted();
    };
    const Comparison comparison = compare_methods(scene, options);
    progress.clear();

    const std::string json = io::compare_json(scene, comparison);
    write_file(folder / "compare.csv", io::compare_csv(comparison));
    write_file(folder / "compare.json", json);
    const std::string data = report::comparison_data(scene, comparison);
    write_file(folder / page_data_file, data);
    write_page(folder / "report.html", {data});

    console.out << (global.json ? json : compare_table(scene, comparison));
    if (!global.json)
        for (const char* each : {"compare.csv", "compare.json", "report.html"})
            console.out << (folder / each).string() << '\n';
    if (!global.quiet) {
        tell_what_stopped(comparison, console);
        for (const CompareRow& row : comparison.rows)
            for (const std::string& each : lift_notes(scene, row.lifts)) print_note(console, row.method + ": " + each);
    }
    return comparison.interrupted ? static_cast<int>(exit_interrupted) : worst_exit(comparison);
}

}  // namespace carom::cli
