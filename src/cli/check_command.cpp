#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/notes.hpp"
#include "cli/session.hpp"
#include "cli/tables.hpp"
#include "io/check_json.hpp"

#include <carom/checks.hpp>
#include <carom/error.hpp>
#include <carom/io.hpp>

#include <fmt/format.h>

#include <ostream>

namespace carom::cli {

namespace {

struct Task {
    std::filesystem::path file;
    Scene scene;
};

std::vector<Task> read_all(const CheckArguments& args, Session& session)
{
    std::vector<Task> tasks;
    for (const std::string& each : args.scenes) {
        const std::filesystem::path file = find_scene(each, scene_folder());
        tasks.push_back({file, session.read(file, args.allow_overlap, args.set)});
    }
    return tasks;
}

/// \throws InputError naming the scenes that say nothing to check: "0 of 0 checks hold" would be no answer
void expect_checks(const std::vector<Task>& tasks)
{
    std::vector<std::string> problems;
    for (const Task& task : tasks)
        if (task.scene.checks.empty())
            problems.push_back(task.file.string() +
                               ": /checks: the scene has none, so there is nothing to check (write some, such as "
                               "\"checks\": [{\"type\": \"no_overlap\"}]; carom run runs it without)");
    if (!problems.empty()) throw InputError(problems);
}

double engine_seconds(const std::vector<io::CheckedScene>& checked)
{
    double sum = 0;
    for (const io::CheckedScene& each : checked) sum += each.report.run.study.cpu_seconds;
    return sum;
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
    Session session(args.given, global, console);
    const std::vector<Task> tasks = read_all(args, session);
    expect_checks(tasks);
    std::vector<io::CheckedScene> checked;
    int code = exit_ok;
    for (const Task& task : tasks) {
        if (!session.watch.keep_going()) break;
        CheckOptions options;
        options.on_progress = session.on_time(task.file.stem().string(), task.scene.end_time, task.scene);
        CheckReport report = check_scene(task.scene, options);
        session.progress.clear();
        Outcome& outcome = report.run.study.outcome;
        if (session.watch.ended()) {
            session.watch.name_reason(outcome);
            report.results = evaluate_checks(task.scene, report.run);
        }
        code = worse(code, report.any_fails() ? static_cast<int>(exit_check_failed) : exit_code(outcome.status));
        if (!global.json) console.out << check_table(task.scene, task.file.stem().string(), report);
        if (outcome.status != Status::reached_end && !global.quiet)
            print_error(console, fmt::format("{}: {}: {}", task.file.string(), name(outcome.status), outcome.message));
        if (const std::string advice = unresolved_advice(outcome); !advice.empty() && !global.quiet)
            print_note(console, task.file.string() + ": " + advice);
        if (!global.quiet)
            for (const std::string& each : lift_notes(task.scene, report.run.study.lifts))
                print_note(console, task.file.string() + ": " + each);
        checked.push_back({task.file.stem().string(), task.scene.name, report});
    }
    const io::CommandFacts facts = session.watch.facts();
    if (facts.stopped) code = facts.stopped == Status::interrupted ? exit_interrupted : worse(code, exit_limit);
    if (facts.stopped && checked.size() < tasks.size() && !global.quiet)
        print_error(console, fmt::format("{}: {} of {} scenes were not run", session.watch.reason(),
                                         tasks.size() - checked.size(), tasks.size()));
    if (global.json)
        console.out << io::check_json(checked, facts);
    else
        console.out << "Clock: " << clock_text(facts, engine_seconds(checked), "the engine") << '\n';
    return code;
}

}  // namespace carom::cli
