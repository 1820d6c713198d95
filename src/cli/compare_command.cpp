#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/notes.hpp"
#include "cli/page_files.hpp"
#include "cli/session.hpp"
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
    Session session(args.given, global, console);
    const std::filesystem::path file = find_scene(args.scene, scene_folder());
    const Scene scene = session.read(file, args.allow_overlap, args.set);
    CompareSettings settings = compare_settings(args, global, scene, file.string());
    session.watch.limit(settings.max_seconds);
    const std::filesystem::path folder = args.out.empty()
                                             ? std::filesystem::path("out") / ("compare-" + file.stem().string())
                                             : std::filesystem::path(args.out);

    for (const std::string& each : settings.absent) print_note(console, each);
    if (!global.quiet)
        for (const std::string& each : unused_materials(scene, args.set)) print_note(console, each);

    settings.compare.on_progress = session.on_progress();
    const Comparison comparison = compare_methods(scene, settings.compare);
    session.progress.clear();

    const io::CommandFacts facts = session.watch.facts();
    const std::string json = io::compare_json(scene, comparison, facts);
    write_file(folder / "compare.csv", io::compare_csv(comparison));
    write_file(folder / "compare.json", json);
    const std::string data = report::comparison_data(scene, comparison);
    write_file(folder / page_data_file, data);
    write_page(folder / "report.html", {data});

    console.out << (global.json ? json : compare_table(scene, comparison));
    if (!global.json) {
        console.out << "Clock: " << clock_text(facts, comparison.reference.cpu_seconds, "the reference") << '\n';
        for (const char* each : {"compare.csv", "compare.json", page_data_file, "report.html"})
            console.out << (folder / each).string() << '\n';
    }
    if (!global.quiet) {
        tell_what_stopped(comparison, console);
        for (const CompareRow& row : comparison.rows)
            for (const std::string& each : lift_notes(scene, row.lifts)) print_note(console, row.method + ": " + each);
    }
    if (facts.stopped && !global.quiet) print_error(console, session.watch.reason());
    if (facts.stopped == Status::interrupted) return exit_interrupted;
    const int worst = worst_exit(comparison);
    return facts.stopped && worst == exit_ok ? exit_limit : worst;
}

}  // namespace carom::cli
