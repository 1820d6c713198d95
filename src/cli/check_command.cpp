#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"
#include "cli/tables.hpp"
#include "io/check_json.hpp"

#include <carom/checks.hpp>
#include <carom/io.hpp>

#include <fmt/format.h>

#include <ostream>

namespace carom::cli {

namespace {

struct Task {
    std::filesystem::path file;
    Scene scene;
};

std::vector<Task> read_all(const CheckArguments& args, const GlobalArguments& global)
{
    std::vector<Task> tasks;
    for (const std::string& each : args.scenes) {
        const std::filesystem::path file = find_scene(each, scene_folder());
        tasks.push_back({file, read_with_options(file, args.allow_overlap, args.set, global)});
    }
    return tasks;
}

/// A failed check says more than a run that ended early, and that more than one which went to its end.
int worse(int a, int b)
{
    const auto rank = [](int code) {
        return code == exit_check_failed ? 3 : code == exit_failed ? 2 : code != exit_ok;
    };
    return rank(a) >= rank(b) ? a : b;
}

}  // namespace

int do_check(const CheckArguments& args, const GlobalArguments& global, const Console& console)
{
    const std::vector<Task> tasks = read_all(args, global);
    const InterruptGuard guard;
    ProgressLine progress(console, global);
    std::vector<io::CheckedScene> checked;
    int code = exit_ok;
    for (const Task& task : tasks) {
        CheckOptions options;
        options.on_progress = [&](double time) {
            progress.show(task.file.stem().string(), time / task.scene.end_time);
            return !guard.interrupted();
        };
        const CheckReport report = check_scene(task.scene, options);
        progress.clear();
        const Outcome& outcome = report.run.study.outcome;
        if (outcome.status == Status::interrupted) return exit_interrupted;
        code = worse(code, report.any_fails() ? static_cast<int>(exit_check_failed) : exit_code(outcome.status));
        if (!global.json) console.out << check_table(task.scene, task.file.stem().string(), report);
        if (outcome.status != Status::reached_end && !global.quiet)
            print_error(console, fmt::format("{}: {}: {}", task.file.string(), name(outcome.status), outcome.message));
        if (const std::string advice = unresolved_advice(outcome); !advice.empty() && !global.quiet)
            print_note(console, task.file.string() + ": " + advice);
        checked.push_back({task.file.stem().string(), task.scene.name, report});
    }
    if (global.json) console.out << io::check_json(checked);
    return code;
}

}  // namespace carom::cli
