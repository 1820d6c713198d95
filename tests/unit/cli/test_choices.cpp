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

Scene scene_with(const CommandDefaults& defaults)
{
    Scene scene;
    scene.end_time = 5;
    scene.run = scene.compare = defaults;
    return scene;
}

}  // namespace

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
                      Contains("ball.json: /run/guard: unknown word \"true\" (take: on, off, moreau, velocity, pbd, windows)"));
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

TEST_CASE("options of one method set it, from the command line and from the scene, and say when they have no effect",
          "[choices]")
{
    RunArguments args;
    args.given = {{"method", "soft"}, {"hertz", "60"}, {"damping_ratio", "1/2"}};
    const Method soft = run_settings(args, {}, scene_with({}), "ball.json").method;
    REQUIRE(std::holds_alternative<Soft>(soft));
    CHECK(std::get<Soft>(soft).hertz == 60);
    CHECK(std::get<Soft>(soft).damping_ratio == 0.5);
    CHECK(ignored_options(args.given, soft).empty());

    Scene scene = scene_with({});
    scene.run = {{"method", std::string("penalty")}, {"stiffness", 1e4}};
    const Method penalty = run_settings({}, {}, scene, "ball.json").method;
    CHECK(std::get<Penalty>(penalty).stiffness == 1e4);
    scene.run.erase("stiffness");
    CHECK_FALSE(std::get<Penalty>(run_settings({}, {}, scene, "ball.json").method).stiffness.has_value());
    const std::vector<std::string> notes = ignored_options(args.given, penalty);
    REQUIRE(notes.size() == 2);
    CHECK(notes[0] == "--hertz has no effect: it is for --method soft");
    CHECK(notes[1] == "--damping-ratio has no effect: it is for --method soft");
    args.given["hertz"] = "0";
    CHECK_THROWS_AS(run_settings(args, {}, scene_with({}), "ball.json"), UsageError);

    CompareArguments compare;
    scene.compare = {{"stiffness", 2e3}, {"hertz", 40.0}};
    compare.given = {{"hertz", "60"}, {"damping_ratio", "1/2"}};
    const CompareOptions options = compare_settings(compare, {}, scene, "ball.json").compare;
    CHECK(options.stiffness == 2e3);
    CHECK(options.hertz == 60);
    CHECK(options.damping_ratio == 0.5);
    CHECK_FALSE(compare_settings(compare, {}, scene_with({}), "ball.json").compare.stiffness.has_value());
}

TEST_CASE("a wrong value is a usage error if typed and a scene error if written in the scene", "[choices]")
{
    const std::vector<std::pair<std::string, std::string>> wrong{{"dt", "0"},       {"dt", "x"},
                                                                 {"substeps", "0"}, {"order", "best"},
                                                                 {"until", "-1"},   {"methods", "event,magic"},
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
