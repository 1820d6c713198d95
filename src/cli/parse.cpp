#include "cli/arguments.hpp"
#include "cli/define.hpp"
#include "cli/exit_codes.hpp"
#include "cli/lists.hpp"
#include "cli/tables.hpp"
#include "cli/usage_error.hpp"

#include <carom/method.hpp>
#include <carom/response.hpp>

#include <algorithm>
#include <sstream>

#ifndef CAROM_VERSION
#define CAROM_VERSION "0"
#endif

namespace carom::cli {

void add_given(CLI::App& app, GivenOptions& given, const std::string& flag, const std::string& value,
               const std::string& help)
{
    std::string key = flag.substr(flag.find_first_not_of('-'));
    std::replace(key.begin(), key.end(), '-', '_');
    app.add_option_function<std::string>(
           flag, [&given, key](const std::string& text) { given[key] = text; }, help)
        ->type_name(value);
}

void add_time_limit(CLI::App& app, GivenOptions& given)
{
    add_given(app, given, "--max-seconds", "S",
              "Stop after so many seconds on the clock, counted from the start of the command");
}

void add_scene_options(CLI::App& app, bool& allow_overlap, std::vector<std::string>& set)
{
    app.add_flag("--allow-overlap", allow_overlap, "Let bodies overlap at the start");
    app.add_option("--set", set, "Change the scene before it is read: a JSON value or a bare string; repeatable")
        ->type_name("/POINTER=VALUE")
        ->allow_extra_args(false);
}

namespace {

template <class Names>
std::string joined(const Names& names)
{
    return CLI::detail::join(names, ", ");
}

void add_literal(CLI::App& app, GivenOptions& given)
{
    app.add_flag_callback(
        "--literal", [&given] { given["literal"] = "true"; },
        "pbd only: respond to separating contacts too, as the original text says");
}

void add_step_options(CLI::App& app, GivenOptions& given)
{
    add_given(app, given, "--order", "ORDER",
              "Order of contacts in a pass: " + joined(contact_order_names) +
                  " (jacobi: pbd only; shock: velocity and moreau only) [index]");
    add_given(app, given, "--integrator", "I",
              "Motion between contacts: " + joined(integrator_names) + ", which is exact in flight [euler]");
    add_literal(app, given);
}

void add_springs(CLI::App& app, GivenOptions& given)
{
    add_given(app, given, "--stiffness", "K", "penalty only: of every spring [two bodies: ten substeps in contact]");
    add_given(app, given, "--hertz", "F", "soft only: frequency of the spring of an overlap [30]");
    add_given(app, given, "--damping-ratio", "Z", "soft only: damping ratio of that spring [10]");
}

void define_run(CLI::App& app, RunArguments& run)
{
    app.add_option("scene", run.scene, "Scene file, or a name of the catalogue (carom scenes)")
        ->required()
        ->type_name("SCENE");
    add_given(app, run.given, "--method", "METHOD", CLI::detail::join(method_names(), ", ") + " [event]");
    add_given(app, run.given, "--dt", "H", "Step of a discrete method; 1/240 is a number [1/240]");
    add_given(app, run.given, "--substeps", "N", "Substeps of a step [1]");
    add_given(app, run.given, "--passes", "N", "Passes over the contacts in a substep [1]");
    add_step_options(app, run.given);
    add_given(app, run.given, "--most-impacts", "N",
              "toi only: impacts of a sphere in a substep; further ones do not rebound [100]");
    add_springs(app, run.given);
    add_given(app, run.given, "--kernel", "K", "Force a kernel of the event method (carom explain lists them)");
    app.add_flag_callback(
        "--certified", [&run] { run.given["certified"] = "true"; },
        "event only: places in double-double, no gap below 0 in free flight; for carom verify");
    add_given(app, run.given, "--impact", "OP",
              "How contacts that close together are resolved: " + joined(impact_operator_names) + " [the scene's]");
    add_given(
        app, run.given, "--guard", "G",
        "Where inelastic impacts accumulate: on, off, or on with " + joined(guard_fallback_names) + " [the scene's]");
    add_given(app, run.given, "--until", "T", "End of the run, counted from its start [the scene's end_time]");
    add_given(app, run.given, "--max-events", "N", "Stop after so many events, or steps of a discrete method [1e9]");
    add_time_limit(app, run.given);
    app.add_option(
           "--events", run.events,
           "Write the events to this file, or for - to stdout and the table to stderr; times exact: the shortest "
           "text of the same double, or all digits if it is none")
        ->type_name("FILE.csv");
    app.add_flag("--final", run.always_final, "Write final states of more than 1000 spheres too");
    add_given(app, run.given, "--frames", "FPS",
              "Write DIR/frames.csv (-o DIR): t,id,x,y,z of each sphere so many times per unit of time");
    add_scene_options(app, run.allow_overlap, run.set);
    app.add_option("-o,--out", run.out, "Write DIR/run.json and the recording DIR/run.carom")->type_name("DIR");
    app.footer(
        "Examples:\n"
        "  carom run bouncing_ball\n"
        "  carom run bouncing_ball --method pbd --dt 1/240 --json\n"
        "  carom run gas_1000 --until 1 --events gas.csv -o out/gas\n"
        "  carom run cradle --impact lcp --guard off\n"
        "  carom run gas_1000 --method pbd --frames 240 -o out/frames\n"
        "  carom run bouncing_ball --set /materials/rubber/restitution=0.5 --set /spheres/0/position=[0,0,2.1]\n"
        "Exit: 0 end reached, 1 run failed or unresolved, 2 usage, 3 bad scene, 5 a limit was reached, 130 "
        "interrupted.");
}

void define_compare(CLI::App& app, CompareArguments& compare)
{
    app.add_option("scene", compare.scene, "Scene file, or a name of the catalogue (carom scenes)")
        ->required()
        ->type_name("SCENE");
    add_given(
        app, compare.given, "--methods", "LIST",
        "Methods to compare, and engines of others: bullet, bullet_ccd, bullet_defaults, ode, ode_defaults [carom's]");
    add_given(app, compare.given, "--dt", "LIST",
              "Steps: a,b,c or start:stop:logN or start:stop:linN [1/60,1/240,1/1000]");
    add_given(app, compare.given, "--substeps", "LIST", "Substeps of a step, every one is run [1]");
    add_given(app, compare.given, "--passes", "LIST",
              "Passes over the contacts in a substep, every one is run where a method reads them [1]");
    add_given(app, compare.given, "--order", "LIST",
              "Orders of contacts in a pass: " + joined(contact_order_names) + " (pbd only) [index]");
    add_given(app, compare.given, "--integrator", "LIST",
              "Motions between contacts: " + joined(integrator_names) + " [both where gravity or drag bends paths]");
    add_given(app, compare.given, "--impact", "LIST",
              "Operators of the event method for several contacts at once: " + joined(impact_operator_names) +
                  " [the scene's]");
    add_literal(app, compare.given);
    add_springs(app, compare.given);
    add_given(app, compare.given, "--until", "T", "End of the runs, counted from their start [the scene's end_time]");
    add_given(app, compare.given, "--repeats", "K", "Runs for the time, of which the median counts [3]");
    add_given(app, compare.given, "--tolerance", "X",
              "Position error that the verdict asks for [1 mm if fit, else 0.01 smallest radius]; given, the largest "
              "step of each method within it is searched for, by runs of up to 10 s for each");
    add_time_limit(app, compare.given);
    add_scene_options(app, compare.allow_overlap, compare.set);
    app.add_option("-o,--out", compare.out,
                   "Folder for compare.csv, compare.json, report.html and page.json, its data [out/compare-NAME]")
        ->type_name("DIR");
    app.footer(
        "Examples:\n"
        "  carom compare bouncing_ball\n"
        "  carom compare bullet --methods event,pbd,bisection --dt 1e-5:1/60:log7 -o out/bullet\n"
        "  carom compare incline --dt 1/60,1/240 --substeps 1,4 --tolerance 1e-4 --json\n"
        "  carom compare bouncing_ball --tolerance 1e-3       which step keeps within 1 mm, and what it costs\n"
        "Columns of the table:\n" +
        std::string(compare_legend) +
        "Exit: 0 all runs reached the end, 1 one failed or is unresolved, 2 usage, 3 bad scene, 5 a limit was reached, "
        "130 interrupted.");
}

void define_check(CLI::App& app, CheckArguments& check)
{
    app.add_option("scenes", check.scenes, "Scene files, or names of the catalogue")->required()->type_name("SCENE...");
    add_time_limit(app, check.given);
    add_scene_options(app, check.allow_overlap, check.set);
    app.footer(
        "Runs the event method to the scene's end_time and asks whether what the scene's \"checks\" say holds.\n"
        "Examples:\n"
        "  carom check bouncing_ball\n"
        "  carom check bouncing_ball incline my_scene.json --json\n"
        "  carom check bouncing_ball --set /materials/rubber/restitution=0.5\n"
        "Exit: 0 all hold, 4 one fails, 1 none fails but a run ended unresolved before its end, 5 at a limit, 3 bad "
        "scene\n"
        "or one without checks, and then nothing is run, 130 interrupted.");
}

void define_explain(CLI::App& app, ExplainArguments& explain)
{
    app.add_option("scene", explain.scene, "Scene file, or a name of the catalogue")->required()->type_name("SCENE");
    app.add_option("--kernel", explain.kernel, "Explain what forcing this kernel does")->type_name("K");
    add_scene_options(app, explain.allow_overlap, explain.set);
    app.footer(
        "Says what a scene needs of the engine, which kernel and broad phase run it, what its reference is, and why.\n"
        "Examples:\n"
        "  carom explain bouncing_ball\n"
        "  carom explain gas_1000 --json\n"
        "Exit: 0 explained, 2 usage, 3 bad scene.");
}

void define_stress(CLI::App& app, StressArguments& stress)
{
    app.add_option("cases", stress.only, "Only these cases [all]")->type_name("CASE...");
    add_given(app, stress.given, "--methods", "LIST", "Methods to put to the test [all]");
    app.add_flag("--list", stress.list, "Say what cases there are, and run none");
    add_time_limit(app, stress.given);
    app.add_option("-o,--out", stress.out, "Write DIR/stress.csv, DIR/stress.json and the page DIR/report.html")
        ->type_name("DIR");
    app.footer(
        "Examples:\n"
        "  carom stress\n"
        "  carom stress --list\n"
        "  carom stress grazing zeno --methods event,pbd\n"
        "  carom stress -o out/stress --json\n"
        "What cases show, and where their numbers come from: docs/stress.md.\n"
        "Exit: 0 event passes all that is required, 4 it fails a case, 2 usage, 3 bad scene, 5 a limit was reached,\n"
        "130 interrupted.");
}

void define_report(CLI::App& app, ReportArguments& report)
{
    app.add_option("folders", report.folders, "Folders that compare wrote")->required()->type_name("DIR...");
    app.add_option("-o,--out", report.out, "The page [DIR/report.html; out/report.html for several]")
        ->type_name("F.html");
    add_time_limit(app, report.given);
    app.footer(
        "Examples:\n"
        "  carom report out/compare-bouncing_ball out/compare-bullet -o out/all.html\n"
        "Exit: 0 written, 2 usage, 3 a folder is none of compare's or the page cannot be written, 5 a limit was "
        "reached, "
        "130 interrupted.");
}

std::uint64_t seed_option(const std::string& text)
{
    try {
        return parse_seed(text);
    } catch (const std::invalid_argument& error) {
        throw CLI::ValidationError("--seed", error.what());
    }
}

void define_global(CLI::App& app, GlobalArguments& global)
{
    app.set_version_flag("--version", std::string("carom ") + CAROM_VERSION);
    app.add_flag("--json", global.json, "One JSON object on stdout, nothing else");
    app.add_flag("-q,--quiet", global.quiet, "Nothing on stderr but errors");
    app.add_flag("-v,--verbose", global.verbose, "Say more on stderr");
    app.add_flag("--no-progress", global.no_progress, "No progress line");
    app.add_option_function<std::string>(
           "--seed", [&global](const std::string& text) { global.seed = seed_option(text); },
           "Seed of every random choice, a whole number from 0 to 2^64 - 1 [the scene's]")
        ->type_name("N");
    app.fallthrough();
    app.require_subcommand(1);
    app.footer(
        "Examples:\n"
        "  carom scenes\n"
        "  carom run bouncing_ball\n"
        "  carom compare bouncing_ball\n"
        "Each command has its own help: carom run -h. NO_COLOR in the environment turns colours off.");
}

}  // namespace

ParseResult parse_arguments(const std::vector<std::string>& args)
{
    ParseResult result;
    if (const auto later = later_feature(args)) {
        result.exit_code = exit_usage;
        result.err = "carom: " + *later + "\n";
        return result;
    }
    Arguments arguments;
    CLI::App app("Exact-contact simulation of rigid spheres among planes, and what a time step costs against it",
                 "carom");
    define_global(app, arguments.global);
    CLI::App* run = app.add_subcommand("run", "Run a scene with one method");
    define_run(*run, arguments.run);
    CLI::App* compare = app.add_subcommand("compare", "Error against run time of several methods and steps");
    define_compare(*compare, arguments.compare);
    CLI::App* check = app.add_subcommand("check", "Run scenes and evaluate their checks");
    define_check(*check, arguments.check);
    CLI::App* explain = app.add_subcommand("explain", "What a scene needs, and which kernel runs it");
    define_explain(*explain, arguments.explain);
    CLI::App* stress = app.add_subcommand("stress", "Stiff and extreme cases: who passes, and why others fail");
    define_stress(*stress, arguments.stress);
    CLI::App* tunnel = app.add_subcommand("tunnel", "Who goes through thin walls: speeds, steps and the law");
    define_tunnel(*tunnel, arguments.tunnel);
    CLI::App* verify = app.add_subcommand("verify", "Certificate of a recorded run");
    define_verify(*verify, arguments.verify);
    CLI::App* audit = app.add_subcommand("audit", "Contacts missed, late, invented in the frames of any engine");
    define_audit(*audit, arguments.audit);
    CLI::App* report = app.add_subcommand("report", "One self-contained page of one or more comparisons");
    define_report(*report, arguments.report);
    CLI::App* scenes = app.add_subcommand("scenes", "The catalogue of scenes");
    define_scenes(*scenes, arguments.scenes);

    CLI::App* toi = app.add_subcommand("toi", "Times of impact as a service: one line asks, one answers");
    define_toi(*toi);

    const auto global_help = [](CLI::App* command) {
        command->footer(command->get_footer() + "\nEverywhere: --json, -q, -v, --no-progress, --seed N (see carom -h)");
    };
    for (CLI::App* command : {run, compare, check, explain, stress, tunnel, verify, audit, report, scenes, toi})
        global_help(command);

    try {
        app.parse(std::vector<std::string>(args.rbegin(), args.rend()));  // CLI11 takes them last first
    } catch (const CLI::ParseError& error) {
        std::ostringstream out, err;
        result.exit_code = app.exit(error, out, err) == 0 ? exit_ok : exit_usage;
        result.out = out.str();
        if (result.exit_code != exit_ok) result.err = usage_error(app, error, args);
        return result;
    }
    arguments.command = run->parsed()       ? Command::run
                        : compare->parsed() ? Command::compare
                        : check->parsed()   ? Command::check
                        : explain->parsed() ? Command::explain
                        : stress->parsed()  ? Command::stress
                        : tunnel->parsed()  ? Command::tunnel
                        : verify->parsed()  ? Command::verify
                        : audit->parsed()   ? Command::audit
                        : report->parsed()  ? Command::report
                        : toi->parsed()     ? Command::toi
                                            : Command::scenes;
    result.arguments = std::move(arguments);
    return result;
}

}  // namespace carom::cli
