#include "cli/choices.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/interrupt.hpp"
#include "cli/page_files.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "io/compare_files.hpp"
#include "report/page_data.hpp"

#include <carom/io.hpp>

#include <ostream>

namespace carom::cli {

int do_compare(const CompareArguments& args, const GlobalArguments& global, const Console& console)
{
    const std::filesystem::path file = find_scene(args.scene, scene_folder());
    const Scene scene = read_with_options(file, args.allow_overlap, args.set, global);
    CompareOptions options = compare_settings(args, global, scene, file.string());
    const std::filesystem::path folder = args.out.empty()
                                             ? std::filesystem::path("out") / ("compare-" + file.stem().string())
                                             : std::filesystem::path(args.out);

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
    return comparison.interrupted ? exit_interrupted : exit_ok;
}

}  // namespace carom::cli
