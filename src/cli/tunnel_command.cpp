#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/page_files.hpp"
#include "cli/session.hpp"
#include "cli/tables.hpp"
#include "cli/tunnel_settings.hpp"
#include "io/tunnel_files.hpp"
#include "report/page.hpp"
#include "report/tunnel_page.hpp"
#include "tunnel/scene_throws.hpp"

#include <carom/io.hpp>

#include <ostream>
#include <set>

namespace carom::cli {

namespace {

/// "velocity", "velocity-parabola".
std::string file_of(const tunnel::Row& row)
{
    return row.method + (row.integrator == Integrator::parabola ? "-parabola" : "") + ".json";
}

/// The first throw of each method, by integrator, that tunnelled, as a scene to be run.
void write_throws(const std::filesystem::path& folder, const tunnel::Report& report, std::vector<std::string>& files)
{
    std::set<std::string> shown;
    for (const tunnel::Row& row : report.rows) {
        if (row.tunnelled == 0 || !shown.insert(file_of(row)).second) continue;
        const std::filesystem::path file = folder / "throws" / file_of(row);
        write_file(file, io::throw_scene_json(row));
        files.push_back(file.string());
    }
}

/// Scenes that the cells of a scene's page open, by row; none where no throw failed. Those of the matrix the page
/// makes.
std::vector<std::string> example_scenes(const tunnel::Report& report)
{
    std::vector<std::string> scenes;
    if (report.scene.empty()) return scenes;
    for (const tunnel::Row& row : report.rows)
        scenes.push_back(row.tunnelled + row.wrong > 0 ? io::throw_scene_json(row) : "");
    return scenes;
}

std::vector<std::string> write_files(const std::filesystem::path& folder, const tunnel::Report& report,
                                     const std::string& json)
{
    std::vector<std::string> files;
    const auto write = [&](const char* name, const std::string& text) {
        write_file(folder / name, text);
        files.push_back((folder / name).string());
    };
    write("tunnel.csv", io::tunnel_csv(report));
    if (!report.criticals.empty()) write("critical.csv", io::critical_csv(report));
    write("tunnel.json", json);
    write("report.html", comparison_page(report::tunnel_page_data(report, page_generator(), example_scenes(report))));
    write_throws(folder, report, files);
    return files;
}

}  // namespace

int do_tunnel(const TunnelArguments& args, const GlobalArguments& global, const Console& console)
{
    Session session(args.given, global, console);
    Scene scene;
    std::filesystem::path file;
    if (!args.scene.empty()) {
        file = find_scene(args.scene, scene_folder());
        scene = session.read(file, args.allow_overlap, args.set);
    }
    const TunnelSettings settings =
        tunnel_settings(args, global, scene, file.string(), [&] { return session.watch.keep_going(); });
    session.watch.limit(settings.max_seconds);

    tunnel::Report report;
    report.seed = settings.matrix.seed;
    report.absent = settings.absent;
    for (const tunnel::Contestant& who : settings.contestants)
        if (!who.settings.empty()) report.engines.push_back({who.method, who.settings});
    const OnProgress on_progress = session.on_progress();
    try {
        if (file.empty())
            tunnel::run_matrix(settings.matrix, settings.contestants, report, on_progress);
        else
            tunnel::run_scene(scene, settings.matrix, settings.contestants, report, on_progress);
        if (settings.bisect && !report.interrupted && file.empty())
            tunnel::find_criticals(settings.matrix, settings.contestants, report, on_progress);
        else if (settings.bisect && !report.interrupted)
            tunnel::find_scene_criticals(scene, settings.matrix, settings.contestants, report, on_progress);
    } catch (const Stopped&) {  // while an engine's program was awaited
        report.interrupted = true;
    }
    session.progress.clear();

    const io::CommandFacts facts = session.watch.facts();
    const std::string json = io::tunnel_json(report, facts);
    std::vector<std::string> files;
    if (!args.out.empty()) files = write_files(args.out, report, json);
    console.out << (global.json ? json : tunnel_table(report));
    if (!global.json) {
        console.out << "Clock: " << clock_text(facts, facts.cpu_seconds, "the throws") << '\n';
        for (const std::string& each : files) console.out << each << '\n';
    }
    if (facts.stopped && !global.quiet) print_error(console, session.watch.reason());
    if (facts.stopped == Status::interrupted) return exit_interrupted;
    if (!report.exact_hold()) return exit_check_failed;
    return facts.stopped ? exit_limit : exit_ok;
}

}  // namespace carom::cli
