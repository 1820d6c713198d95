#include "cli/arguments.hpp"
#include "cli/choices.hpp"
#include "cli/exit_codes.hpp"
#include "cli/notes.hpp"
#include "cli/progress.hpp"
#include "cli/response.hpp"

#include <carom/error.hpp>

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::cli;
using Catch::Matchers::Contains;

namespace {

Arguments parsed(const std::vector<std::string>& args)
{
    const ParseResult result = parse_arguments(args);
    INFO(result.err);
    REQUIRE(result.arguments);
    return *result.arguments;
}

Scene scene_with(const CommandDefaults& defaults)
{
    Scene scene;
    scene.end_time = 5;
    scene.run = scene.compare = defaults;
    return scene;
}

}  // namespace

TEST_CASE("options are read where the contract puts them, global ones anywhere", "[arguments]")
{
    const Arguments run =
        parsed({"--json", "run", "ball", "--method", "pbd", "--dt", "1/240", "--max-events", "10", "--final", "-o", "x",
                "--events", "e.csv", "--seed", "7", "-q", "--literal", "--allow-overlap"});
    CHECK(run.command == Command::run);
    CHECK(run.global.json);
    CHECK(run.global.quiet);
    CHECK(run.global.seed == std::optional<std::uint64_t>(7));
    CHECK(run.run.scene == "ball");
    CHECK(run.run.given == GivenOptions{{"method", "pbd"}, {"dt", "1/240"}, {"max_events", "10"}, {"literal", "true"}});
    CHECK(run.run.always_final);
    CHECK(run.run.allow_overlap);
    CHECK(run.run.out == "x");
    CHECK(run.run.events == "e.csv");

    const Arguments compare =
        parsed({"compare", "ball", "--methods", "event,pbd", "--dt", "1e-3:1e-1:log3", "--no-progress"});
    CHECK(compare.command == Command::compare);
    CHECK(compare.compare.given.at("methods") == "event,pbd");
    CHECK(compare.global.no_progress);
    CHECK(parsed({"report", "a", "b", "-o", "c.html"}).report.folders == std::vector<std::string>{"a", "b"});
    const Arguments stress = parsed({"stress", "--methods", "event", "--case", "zeno", "-o", "x"});
    CHECK(stress.command == Command::stress);
    CHECK(stress.stress.given.at("methods") == "event");
    CHECK(stress.stress.only == "zeno");
    CHECK(stress.stress.out == "x");
    CHECK(parsed({"verify", "out/x"}).verify.run == "out/x");
    CHECK(parsed({"verify", "out/x", "--all-pairs"}).verify.all_pairs);
    CHECK(parsed({"scenes"}).scenes.show.empty());
    CHECK(parsed({"scenes", "list"}).command == Command::scenes);
    CHECK(parsed({"scenes", "show", "ball"}).scenes.show == "ball");
}

TEST_CASE("a seed is taken as it is written or refused, never as another number", "[arguments]")
{
    for (const char* word : {"0", "7", "10", "18446744073709551615"}) {
        CAPTURE(word);
        CHECK(std::to_string(parsed({"run", "ball", "--seed", word}).global.seed.value()) == word);
    }
    for (const char* word :
         {"-1", "+5", "010", "00", "0x10", "1e3", "1e23", "1.5", "18446744073709551616", " 5", "5 ", "seven"}) {
        CAPTURE(word);
        for (const auto& args : {std::vector<std::string>{"run", "ball", "--seed", word},
                                 std::vector<std::string>{"--seed", word, "check", "ball"},
                                 std::vector<std::string>{"run", "ball", std::string("--seed=") + word}}) {
            const ParseResult result = parse_arguments(args);
            CHECK_FALSE(result.arguments);
            CHECK(result.exit_code == exit_usage);
            CHECK_THAT(result.err, Contains("--seed: \"" + std::string(word) +
                                            "\" is no whole number from 0 to 18446744073709551615"));
        }
    }
}

TEST_CASE("an empty seed is none", "[arguments]")
{
    CHECK(parse_arguments({"run", "ball", "--seed", ""}).exit_code == exit_usage);
}

TEST_CASE("help and version succeed on stdout, at every level and with examples", "[arguments]")
{
    for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{{"-h"},
                                                                                      {"run", "-h"},
                                                                                      {"compare", "--help"},
                                                                                      {"report", "-h"},
                                                                                      {"check", "-h"},
                                                                                      {"explain", "-h"},
                                                                                      {"stress", "-h"},
                                                                                      {"verify", "-h"},
                                                                                      {"scenes", "-h"},
                                                                                      {"scenes", "list", "-h"},
                                                                                      {"scenes", "show", "-h"}}) {
        const ParseResult result = parse_arguments(args);
        CHECK(result.exit_code == exit_ok);
        CHECK_FALSE(result.arguments);
        if (args.size() == 2) CHECK_THAT(result.out, Contains("\nExit: 0 "));
        CHECK_THAT(result.out, Contains("Examples:") && Contains("carom"));
        CHECK(result.err.empty());
    }
    const ParseResult version = parse_arguments({"--version"});
    CHECK(version.exit_code == exit_ok);
    CHECK_THAT(version.out, Contains("carom "));
}

TEST_CASE("usage errors exit with 2 and say so on stderr", "[arguments]")
{
    for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{{},
                                                                                      {"fly"},
                                                                                      {"run"},
                                                                                      {"run", "ball", "--speed", "3"},
                                                                                      {"run", "ball", "--dt"},
                                                                                      {"run", "a", "b"},
                                                                                      {"report"},
                                                                                      {"--seed", "x", "scenes"},
                                                                                      {"scenes", "show"}}) {
        const ParseResult result = parse_arguments(args);
        CHECK(result.exit_code == exit_usage);
        CHECK_FALSE(result.arguments);
        CHECK_FALSE(result.err.empty());
        CHECK(result.out.empty());
    }
}

TEST_CASE("usage errors name what is wrong and what was probably meant", "[arguments]")
{
    const auto said = [](const std::vector<std::string>& args) { return parse_arguments(args).err; };
    CHECK(said({"run", "ball", "--untill", "2"}) == "carom run: unknown option --untill (did you mean --until?)\n");
    CHECK(said({"run", "ball", "--untill=2"}) == "carom run: unknown option --untill (did you mean --until?)\n");
    CHECK(said({"compare", "ball", "--xyzzy"}) ==
          "carom compare: unknown option --xyzzy (carom compare -h lists them)\n");
    CHECK(said({"run", "ball", "--no-progres"}) ==
          "carom run: unknown option --no-progres (did you mean --no-progress?)\n");
    CHECK(said({"run"}) == "carom run: the scene is missing (carom run -h has examples)\n");
    CHECK(said({"scenes", "show"}) == "carom scenes show: the scene is missing (carom scenes show -h has examples)\n");
    CHECK(said({"run", "a", "b"}) == "carom run: unexpected argument \"b\" (carom run -h shows what it takes)\n");
    CHECK_THAT(said({}), Contains("carom: a command is missing (take: run, compare"));
    CHECK_THAT(said({"comprae", "ball"}), Contains("did you mean \"compare\"?"));
}

TEST_CASE("an unknown command is named", "[arguments]")
{
    CHECK_THAT(parse_arguments({"fly", "ball"}).err, Contains("unknown command \"fly\""));
}

TEST_CASE("--set keeps each assignment as typed, and takes one", "[arguments]")
{
    const std::vector<std::string> both{"/a/b=[1, 2]", "/c=x=y"};
    CHECK(parsed({"run", "--set", both[0], "--set=" + both[1], "ball"}).run.set == both);
    CHECK(parsed({"run", "--set", both[0], "ball"}).run.scene == "ball");
    CHECK(parsed({"compare", "ball", "--set", both[0]}).compare.set.size() == 1);
    CHECK(parsed({"check", "ball", "cradle", "--set", both[0]}).check.scenes.size() == 2);
}

TEST_CASE("scenes lists without a word, and validates any number", "[arguments]")
{
    CHECK(parsed({"scenes"}).scenes.action == ScenesAction::list);
    CHECK(parsed({"scenes", "show", "ball"}).scenes.action == ScenesAction::show);
    CHECK(parsed({"scenes", "schema"}).scenes.action == ScenesAction::schema);
    CHECK(parsed({"scenes", "validate"}).scenes.validate.empty());
    CHECK(parsed({"scenes", "validate", "a", "b"}).scenes.validate.size() == 2);
}

TEST_CASE("what belongs to later versions is refused and not in the help", "[arguments]")
{
    std::string help = parse_arguments({"-h"}).out;
    for (const char* command : {"run", "compare", "stress", "scenes"}) help += parse_arguments({command, "-h"}).out;
    for (const char* word : {"tunnel", "view", "export", "query", "--save-state", "--equilibrate", "penalty"}) {
        CAPTURE(word);
        CHECK_THAT(help, !Contains(std::string(" ") + word + " "));
        const bool option = word[0] == '-';
        if (std::string(word) == "penalty") continue;
        const ParseResult result = parse_arguments(option ? std::vector<std::string>{"run", "ball", word}
                                                          : std::vector<std::string>{word, "ball"});
        CHECK(result.exit_code == exit_usage);
        CHECK_THAT(result.err, Contains("not yet"));
    }
    CHECK(parsed({"run", "view"}).run.scene == "view");  // a scene may have any name
}

TEST_CASE("the command line goes before the scene, the scene before what is built in", "[choices]")
{
    const Scene scene = scene_with({{"methods", std::vector<std::string>{"event", "velocity"}},
                                    {"dt", std::vector<std::string>{"1/60", "0.001"}},
                                    {"repeats", 5.0},
                                    {"integrator", std::string("parabola")},
                                    {"literal", true}});
    const CompareOptions from_scene = compare_settings({}, {}, scene, "ball.json").compare;
    CHECK(from_scene.methods == std::vector<std::string>{"event", "velocity"});
    CHECK(from_scene.dt == std::vector<double>{1.0 / 60, 0.001});
    CHECK(from_scene.repeats == 5);
    CHECK(from_scene.step.literal);
    CHECK(from_scene.integrators == std::vector<Integrator>{Integrator::parabola});
    CHECK_FALSE(from_scene.search_steps);
    CHECK(from_scene.until == 5);
    CHECK_FALSE(from_scene.tolerance);

    CompareArguments args;
    args.given = {{"methods", "pbd"},          {"dt", "1/10"},      {"until", "2"},
                  {"tolerance", "1e-4"},       {"substeps", "1,4"}, {"order", "index,jacobi"},
                  {"impact", "lcp,sequential"}};
    const CompareOptions typed = compare_settings(args, {}, scene, "ball.json").compare;
    CHECK(typed.methods == std::vector<std::string>{"pbd"});
    CHECK(typed.dt == std::vector<double>{0.1});
    CHECK(typed.until == 2);
    CHECK(typed.tolerance == std::optional<double>(1e-4));
    CHECK(typed.search_steps);
    CHECK(typed.substeps == std::vector<int>{1, 4});
    CHECK(typed.orders == std::vector<ContactOrder>{ContactOrder::index, ContactOrder::jacobi});
    REQUIRE(typed.impacts);
    CHECK(*typed.impacts == std::vector<ImpactOperator>{ImpactOperator::lcp, ImpactOperator::sequential});
    args.given["impact"] = "lcp,nothing";
    CHECK_THROWS_WITH(compare_settings(args, {}, scene, "ball.json"), Contains("unknown operator \"nothing\""));

    const CompareOptions built_in = compare_settings({}, {}, scene_with({}), "ball.json").compare;
    CHECK(built_in.methods == method_names());
    CHECK(built_in.dt == std::vector<double>{1.0 / 60, 1.0 / 240, 1.0 / 1000});
    CHECK(built_in.repeats == 3);
    CHECK(built_in.integrators == std::vector<Integrator>{Integrator::euler, Integrator::parabola});
}

TEST_CASE("a run's responses are the scene's unless its run section or the command line says otherwise", "[choices]")
{
    Scene scene = scene_with({});
    scene.impact.impact_operator = ImpactOperator::lcp;
    scene.impact.lcp.law = LcpLaw::poisson;
    scene.guard.impacts = 7;
    const Scene untouched = with_response(scene, {}, "ball.json");
    CHECK(untouched.impact.impact_operator == ImpactOperator::lcp);
    CHECK(untouched.guard.on);
    CHECK(untouched.guard.fallback == GuardFallback::moreau);

    scene.run = {{"impact", std::string("shock")}, {"guard", std::string("off")}};
    const Scene preset = with_response(scene, {}, "ball.json");
    CHECK(preset.impact.impact_operator == ImpactOperator::shock);
    CHECK_FALSE(preset.guard.on);

    const Scene typed = with_response(scene, {{"impact", "jacobi"}, {"guard", "velocity"}}, "ball.json");
    CHECK(typed.impact.impact_operator == ImpactOperator::jacobi);
    CHECK(typed.impact.lcp.law == LcpLaw::poisson);
    CHECK(typed.guard.on);
    CHECK(typed.guard.fallback == GuardFallback::velocity);
    CHECK(typed.guard.impacts == 7);
    CHECK(with_response(scene, {{"guard", "on"}}, "ball.json").guard.on);

    CHECK_THROWS_WITH(with_response(scene, {{"impact", "reflection"}}, "ball.json"),
                      Contains("--impact: unknown word \"reflection\" (did you mean \"reflections\"?)"));
    CHECK_THROWS_AS(with_response(scene, {{"guard", "maybe"}}, "ball.json"), UsageError);
    scene.run = {{"guard", true}};
    CHECK_THROWS_WITH(with_response(scene, {}, "ball.json"),
                      Contains("ball.json: /run/guard: unknown word \"true\" (take: on, off, moreau, velocity, pbd)"));
}

TEST_CASE("responses are told in words with every default filled in", "[choices]")
{
    Scene scene = scene_with({});
    CHECK(impact_words(scene) == "reflections, tie 1e-12 r, 0 in certified runs");
    scene.impact.impact_operator = ImpactOperator::lcp;
    scene.impact.tie = 1e-6;
    CHECK(impact_words(scene) == "lcp (newton, exact), tie 1e-06 r");
    scene.impact.lcp.solver = LcpSolver::gauss_seidel;
    CHECK(impact_words(scene) == "lcp (newton, gauss_seidel, 100 sweeps), tie 1e-06 r");
    scene.rest.policy = RestPolicy::micro;
    scene.rest.closing_speed = 0.25;
    scene.rest.window = 0.5;
    scene.rest.numeric_step = 0.125;
    scene.rest.gap_tolerance = 1e-9;
    CHECK(rest_words(scene) ==
          "policy micro; closing speed 0.25, window 0.5, numeric step 0.125, gap tolerance "
          "1e-09, series below 0.001 r");
    CHECK(guard_words(scene) == "more than 100 impacts a body within 0.125; then moreau for one window");
    scene.guard.on = false;
    CHECK_THAT(guard_words(scene), Catch::Matchers::StartsWith("off"));
}

TEST_CASE("a run's method takes its step from the options", "[choices]")
{
    RunArguments args;
    args.given = {{"method", "velocity"},     {"dt", "1/100"},      {"substeps", "3"}, {"order", "deepest"},
                  {"integrator", "parabola"}, {"max_events", "1e3"}};
    GlobalArguments global;
    global.seed = 9;
    const RunSettings settings = run_settings(args, global, scene_with({}), "ball.json");
    REQUIRE(step_options(settings.method) != nullptr);
    CHECK(name(settings.method) == "velocity");
    CHECK(step_options(settings.method)->dt == 0.01);
    CHECK(step_options(settings.method)->substeps == 3);
    CHECK(step_options(settings.method)->order == ContactOrder::deepest);
    CHECK(step_options(settings.method)->integrator == Integrator::parabola);
    CHECK(step_options(settings.method)->seed == 9);
    CHECK(settings.run.max_events == 1000);
    CHECK(settings.run.until == 5);
    CHECK(name(run_settings({}, {}, scene_with({}), "").method) == "event");
}

TEST_CASE("a wrong value is a usage error if typed and a scene error if written in the scene", "[choices]")
{
    const std::vector<std::pair<std::string, std::string>> wrong{{"dt", "0"},
                                                                 {"dt", "x"},
                                                                 {"substeps", "0"},
                                                                 {"order", "best"},
                                                                 {"until", "-1"},
                                                                 {"methods", "event,magic"},
                                                                 {"methods", "penalty"},
                                                                 {"repeats", "0.5"}};
    for (const auto& [key, text] : wrong) {
        CAPTURE(key, text);
        CompareArguments args;
        args.given[key] = text;
        CHECK_THROWS_AS(compare_settings(args, {}, scene_with({}), "ball.json"), UsageError);
        CHECK_THROWS_WITH(compare_settings({}, {}, scene_with({{key, text}}), "ball.json"),
                          Contains("ball.json: /compare/" + key + ": "));
        CHECK_THROWS_AS(compare_settings({}, {}, scene_with({{key, text}}), "ball.json"), InputError);
    }
    CHECK_THROWS_AS(run_settings({}, {}, scene_with({{"speed", 3.0}}), "ball.json"), InputError);
    RunArguments slip;
    for (const char* typed : {"pdb", "PBD"}) {
        slip.given["method"] = typed;
        CHECK_THROWS_WITH(run_settings(slip, {}, scene_with({}), ""), Contains("did you mean \"pbd\"?"));
    }
    CHECK_THROWS_WITH(
        compare_settings({}, {}, scene_with({{"dt", std::vector<std::string>{"1/60", "0"}}}), "ball.json"),
        Contains("/compare/dt: 0 in \"1/60,0\" must be > 0"));
}

TEST_CASE("the impacts that a sphere may have in a substep are an option of toi", "[choices]")
{
    RunArguments args;
    args.given = {{"method", "toi"}, {"most_impacts", "7"}};
    const Method method = run_settings(args, {}, scene_with({}), "ball.json").method;
    CHECK(std::get<ImpactSubsteps>(method).most_impacts == 7);
    args.given["most_impacts"] = "0";
    CHECK_THROWS_WITH(run_settings(args, {}, scene_with({}), "ball.json"), Contains("--most-impacts: "));
}

TEST_CASE("an integrator that does not exist is refused with those that do", "[choices]")
{
    RunArguments args;
    args.given = {{"integrator", "rk4"}};
    CHECK_THROWS_WITH(run_settings(args, {}, scene_with({}), "ball.json"),
                      Contains("--integrator: ") && Contains("euler, parabola"));
    CHECK_THROWS_WITH(run_settings({}, {}, scene_with({{"integrator", std::string("rk4")}}), "ball.json"),
                      Contains("/run/integrator: "));
}

TEST_CASE("options without an effect are noted", "[notes]")
{
    const Method pbd = make_method("pbd", {}), velocity = make_method("velocity", {}), event = EventDriven{};
    CHECK(ignored_options({{"until", "1"}, {"dt", "0.1"}, {"literal", "true"}}, pbd).empty());
    CHECK(ignored_options({{"most_impacts", "3"}}, make_method("toi", {})).empty());
    CHECK_THAT(ignored_options({{"most_impacts", "3"}}, pbd).front(), Contains("--most-impacts has no effect"));
    REQUIRE(ignored_options({{"dt", "0.1"}}, event).size() == 1);
    CHECK_THAT(ignored_options({{"dt", "0.1"}}, event).front(), Contains("--dt has no effect: event takes no steps"));
    CHECK(ignored_options({{"dt", "0.1"}, {"kernel", "general"}, {"literal", "true"}}, velocity).size() == 2);

    Scene scene = scene_with({});
    for (const char* name : {"wood", "wod"}) scene.materials.emplace_back().name = name;
    scene.spheres.emplace_back().material = 1;
    CHECK(unused_materials(scene, {"/materials/wood/restitution=0.5", "/end_time=2"}).empty());
    REQUIRE(unused_materials(scene, {"/materials/wod/restitution=0.5"}).size() == 1);
    CHECK(unused_materials(scene, {"/materials/wod/restitution=0.5"}).front() ==
          "--set /materials/wod/restitution=0.5 has no effect: no body is of the material \"wod\" (did you mean "
          "\"wood\"?)");
}

TEST_CASE("statuses have the contract's exit codes", "[exit]")
{
    CHECK(exit_code(Status::reached_end) == 0);
    CHECK(exit_code(Status::unresolved) == 1);
    CHECK(exit_code(Status::event_limit) == 5);
    CHECK(exit_code(Status::time_limit) == 5);
    CHECK(exit_code(Status::zeno) == 5);
    CHECK(exit_code(Status::interrupted) == 130);
}

TEST_CASE("progress tells the share done, the rate and what is left", "[progress]")
{
    CHECK(progress_text("gas", 0.25, 0.5, "s", 2) == "gas: 25 %, 0.25 s/s, 6 s left");
    CHECK(progress_text("reference", 0, 0, "", 2) == "reference: 0 %");
}
