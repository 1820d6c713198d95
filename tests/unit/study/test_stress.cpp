#include "study/stress.hpp"

#include "core/names.hpp"
#include "flying_through.hpp"
#include "io/stress_scenes.hpp"
#include "stress_closed_forms.hpp"

#include <carom/checks.hpp>
#include <carom/error.hpp>
#include <carom/io.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>

using namespace carom;
using namespace carom::stress;
using namespace carom::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const std::filesystem::path stress_dir = std::filesystem::path(CAROM_SCENE_DIR) / "stress";

/// Runs of 10 s and more of CPU time: not for every day.
const std::set<std::string> long_runs{"long_run, 11,033,380 impacts", "pi_by_impacts, k = 6",
                                      "heavy_top, 1e12 kg on nine of 1 kg"};

const std::vector<Trial>& all_trials()
{
    static const std::vector<Trial> trials = io::read_stress_scenes(stress_dir);
    return trials;
}

/// Without long runs, and without cases of which nothing is left.
std::vector<Case> short_cases()
{
    std::vector<Trial> trials = all_trials();
    std::erase_if(trials, [](const Trial& each) { return long_runs.contains(each.name); });
    return cases_of(trials);
}

Report run_one(const std::string& name, const std::vector<Contestant>& who)
{
    std::vector<Case> cases = short_cases();
    std::erase_if(cases, [&](const Case& each) { return each.words.case_name != name; });
    return run_cases(std::move(cases), who);
}

const Check* check_of(const Scene& scene, CheckType type, BodyId body = no_body)
{
    for (const Check& check : scene.checks)
        if (check.type == type && check.body == body) return &check;
    return nullptr;
}

/// What a scene expects of a sphere is, as far as it expects anything, this state.
void compare(const Scene& scene, BodyId body, const ExpectedState& state)
{
    constexpr double rounding = 4e-16;  // of a figure that is written down, and of one more operation
    INFO(scene.name << ", " << scene.body_name(body));
    if (const Check* check = check_of(scene, CheckType::final_position, body))
        CHECK((check->value - state.position).stableNorm() <= rounding * state.position.stableNorm());
    if (const Check* check = check_of(scene, CheckType::final_velocity, body))
        CHECK((check->value - state.velocity).stableNorm() <= rounding * state.velocity.stableNorm());
}

Scene stress_scene(const std::string& name)
{
    return read_scene(stress_dir / (name + ".json"));
}

}  // namespace

TEST_CASE("stress: each case is in words and has a rule", "[stress]")
{
    std::set<std::string> names;
    for (const Trial& each : all_trials()) {
        INFO(each.name);
        CHECK(names.insert(each.name).second);
        CHECK_FALSE(each.scene.checks.empty());
    }
    for (const std::string& each : long_runs) CHECK(names.contains(each));
    for (const Case& each : cases_of(all_trials())) {
        INFO(each.words.case_name);
        CHECK_FALSE(each.words.title.empty());
        CHECK_FALSE(each.words.figure.empty());
        CHECK_FALSE(each.words.step.empty());
        CHECK_FALSE(each.words.causes.empty());
    }
}

TEST_CASE("stress: the documentation has a row for each case, waiting ones among the waiting", "[stress]")
{
    std::ifstream file(stress_dir.parent_path().parent_path() / "docs" / "stress.md");
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    const std::size_t waiting = text.find("\nWaiting:");
    REQUIRE(waiting != std::string::npos);
    for (const Case& each : cases_of(all_trials())) {
        INFO(each.words.case_name);
        const std::size_t row = text.find("\n| `" + each.words.case_name + "` |");
        REQUIRE(row != std::string::npos);
        CHECK((row < waiting) == each.is_required());
    }
}

TEST_CASE("stress: event passes each case that is required, and fails those that wait for something", "[stress]")
{
    const Report report = run_cases(short_cases(), contestants({"event"}));
    CHECK(report.exact_hold());
    for (const Case& each : report.cases) {
        const Result& result = each.results.at(0);
        INFO(each.words.case_name << ": " << result.figure() << " " << result.reason);
        CHECK(result.passed() == each.is_required());  // what passes need not wait
    }
}

TEST_CASE("stress: bodies that fly through everything fail each case", "[stress]")
{
    const Report report = run_cases(cases_of(all_trials()), {flying_through()});
    std::size_t required = 0, failed = 0;
    for (const Case& each : report.cases) {
        INFO(each.words.case_name);
        CHECK_FALSE(each.results.at(0).passed());
        if (!each.is_required()) continue;
        ++required;
        failed += each.results.at(0).passed() ? 0 : 1;
    }
    CHECK(required == 29);
    CHECK(4 * failed >= 3 * required);
    CHECK(report.exact_hold());  // it does not claim to be exact
}

TEST_CASE("stress: a method that fails a case says where, how and why", "[stress]")
{
    const std::map<std::string, std::pair<std::string, Symptom>> controls{
        {"mass_ratio", {"velocity", Symptom::late}}, {"radius_ratio", {"pbd", Symptom::sank}},
        {"speed", {"bisection", Symptom::missed}},   {"gravity", {"naive", Symptom::invented}},
        {"far_origin", {"pbd", Symptom::late}},      {"ulp_gap", {"naive", Symptom::invented}},
        {"grazing", {"velocity", Symptom::missed}},  {"counting_pi", {"naive", Symptom::sank}},
        {"zeno", {"naive", Symptom::sank}},          {"time_reversal", {"pbd", Symptom::late}},
        {"drift", {"velocity", Symptom::energy}},    {"bullet_into_rest", {"pbd", Symptom::late}},
        {"leaning", {"moreau", Symptom::late}},      {"tower", {"pbd", Symptom::sank}},
        {"wedge", {"velocity", Symptom::missed}},    {"between_heavy", {"moreau", Symptom::sank}},
        {"cluster", {"pbd", Symptom::late}},         {"speed_sweep", {"bisection", Symptom::missed}},
        {"slot", {"pbd", Symptom::missed}},          {"penalty_stiffness", {"penalty", Symptom::stopped}},
    };
    for (const auto& [name, control] : controls) {
        const Report report = run_one(name, contestants({control.first}));
        const Result& result = report.cases.at(0).results.at(0);
        INFO(name << " " << control.first << ": " << result.figure() << " " << result.reason);
        CHECK_FALSE(result.passed());
        CHECK(name_of(result.worst().symptom, symptom_names) == name_of(control.second, symptom_names));
        CHECK_THAT(result.reason, StartsWith(result.worst().trial + ": ") && Contains(": "));
        CHECK(report.exact_hold());  // event was not asked for
    }
}

TEST_CASE("stress: variations are runs of their own, named by their value", "[stress]")
{
    const Report report = run_one("zeno", contestants({"naive"}));
    const std::vector<Finding>& findings = report.cases.at(0).results.at(0).findings;
    const auto of = [&](const std::string& trial) {
        return std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.trial == trial; });
    };
    CHECK(of("zeno") == 1);
    CHECK(of("zeno, e = 0.9999") == 1);
    for (const Trial& each : all_trials())
        if (each.name == "zeno, e = 0.9999") CHECK(each.scene.materials[1].restitution == 0.9999);
}

TEST_CASE("stress: a gas that never meets cannot be turned round", "[stress]")
{
    Scene scene = stress_scene("time_reversal");
    scene.planes.clear();
    scene.spheres.resize(1);
    CHECK(check_scene(scene).results.at(0).verdict == CheckVerdict::fails);
}

TEST_CASE("stress: the evidence is read in the order of causes", "[stress]")
{
    Evidence good;
    good.figure = 0.01;
    CHECK(diagnose(good, 0.01) == Symptom::none);
    CHECK(diagnose(good, 0.0099) == Symptom::late);
    Evidence bad = good;
    bad.figure = std::numeric_limits<double>::quiet_NaN();
    CHECK(diagnose(bad, 1) == Symptom::late);
    bad.invented = 1;
    CHECK(diagnose(bad, 1) == Symptom::invented);
    bad.missed = 1;
    CHECK(diagnose(bad, 1) == Symptom::missed);
    bad.energy = 0.01;
    CHECK(diagnose(bad, 1) == Symptom::energy);
    bad.penetration = 0.5;
    CHECK(diagnose(bad, 1) == Symptom::sank);
    bad.other_events = true;
    CHECK(diagnose(bad, 1) == Symptom::other_run);
    bad.stopped = "why";
    CHECK(diagnose(bad, 1) == Symptom::stopped);
    good.other_events = true;  // another hash fails, however small the differences
    CHECK(diagnose(good, 0.01) == Symptom::other_run);
}

TEST_CASE("stress: event failing a required case fails the report, nothing else does", "[stress]")
{
    Report report;
    report.methods = {"event", "pbd"};
    Case c;
    c.results.resize(2);
    c.results[0].is_exact = true;
    c.results[1].reason = "late";
    report.cases = {c};
    CHECK(report.exact_hold());
    report.cases[0].results[0].reason = "late";
    CHECK_FALSE(report.exact_hold());
    report.cases[0].words.waits_for = "better days";
    CHECK(report.exact_hold());
}

TEST_CASE("stress: the gravest symptom speaks for a case, then the largest figure", "[stress]")
{
    Result result;
    const auto finding = [](const char* trial, double figure, Symptom symptom) {
        Finding each{.trial = trial, .evidence = {}, .symptom = symptom};
        each.evidence.figure = figure;
        return each;
    };
    result.findings = {finding("passes", 0.1, Symptom::none), finding("late", 9, Symptom::late),
                       finding("sank", 1, Symptom::sank), finding("sank deeper", 2, Symptom::sank)};
    CHECK(result.worst().trial == "sank deeper");
    CHECK(result.figure() == 9);
    result.findings.resize(1);
    CHECK(result.worst().trial == "passes");
}

TEST_CASE("stress: scenes of one case add up, and must not disagree about its limits", "[stress]")
{
    Scene one, other;
    one.description = "One.";
    one.stress.emplace().case_name = "both";
    one.stress->title = "Both";
    one.stress->causes[Symptom::late] = "late";
    other.description = "Other.";
    other.stress.emplace().case_name = "both";
    other.stress->causes[Symptom::sank] = "sank";
    other.stress->waits_for = "something";
    const std::vector<Case> cases = cases_of({{"other", other}, {"one", one}, {"one, again", one}});
    REQUIRE(cases.size() == 1);
    CHECK(cases[0].trials.size() == 3);
    CHECK(cases[0].about == "Other. One.");
    CHECK(cases[0].words.title == "Both");
    CHECK(cases[0].words.causes.size() == 2);
    CHECK_FALSE(cases[0].is_required());
    other.stress->limit = 0.02;
    CHECK_THROWS_WITH(cases_of({{"one", one}, {"other", other}}),
                      Contains("both") && Contains("different limits") && Contains("\"other\""));
}

TEST_CASE("stress: an unknown method is refused, and an interruption ends it", "[stress]")
{
    CHECK_THROWS_AS(contestants({"magic"}), InputError);
    CHECK(contestants({}).size() == method_names().size());
    const auto first_case = [](const Progress& now) { return now.what.starts_with("between_heavy"); };
    const Report report = run_cases(short_cases(), contestants({"event"}), first_case);
    CHECK(report.interrupted);
    CHECK(report.cases.size() == 1);
    int asked = 0;
    const auto twice = [&](const Progress&) { return ++asked <= 2; };
    CHECK(run_cases(short_cases(), contestants({"pbd"}), twice).cases.empty());  // in the middle of a run
}

TEST_CASE("stress: the shuttle counts the digits of pi", "[stress]")
{
    // Galperin 2003: with masses 100^k : 1 there are floor(10^k pi) impacts.
    const std::int64_t digits[] = {3, 31, 314, 3141, 31415};
    Real mass = 1;
    for (const std::int64_t expected : digits) {
        Shuttle start;
        start.light = 1;
        start.heavy = 2;
        start.heavy_speed = -1;
        const Shuttle end = after(start, mass, 1000);
        CHECK(end.impacts == expected);
        CHECK(static_cast<double>(mass * end.heavy_speed * end.heavy_speed + end.light_speed * end.light_speed) ==
              Approx(static_cast<double>(mass)).epsilon(1e-14));
        mass *= 100;
    }
}

TEST_CASE("stress: the closed form of two spheres", "[stress]")
{
    Scene scene;
    scene.end_time = 2;
    // The contact normal makes 30 degrees with the path: sin = 1/2 of the contact distance.
    scene.spheres.resize(2);
    scene.spheres[0].radius = scene.spheres[1].radius = 0.25;
    scene.spheres[0].mass = 3;
    scene.spheres[0].position = Vec3(-1, 0.25, 0);
    scene.spheres[0].velocity = Vec3(1, 0, 0);
    const Meeting m = meeting(scene, 0, 1);
    CHECK(m.time == Approx(1 - 0.5 * std::sqrt(0.75)).epsilon(1e-15));
    // The struck sphere leaves along the normal at 2 m_a/(m_a + m_b) cos 30 degrees.
    const double leaving = 1.5 * std::sqrt(0.75);
    CHECK(m.b.velocity.x() == Approx(leaving * std::sqrt(0.75)).epsilon(1e-15));
    CHECK(m.b.velocity.y() == Approx(-leaving * 0.5).epsilon(1e-15));
    CHECK((3 * m.a.velocity + m.b.velocity - Vec3(3, 0, 0)).norm() < 1e-15);
    CHECK((m.b.position - (2 - m.time) * m.b.velocity).norm() < 1e-15);
}

TEST_CASE("stress: what the scenes expect is their closed form", "[stress]")
{
    for (const char* name : {"mass_ratio_heavy", "mass_ratio_light", "radius_ratio_off_centre", "radius_ratio_rim",
                             "ulp_gap_approaching", "ulp_gap_overtaking", "grazing_touch"}) {
        const Scene scene = stress_scene(name);
        const Meeting expected = meeting(scene, 0, 1);
        compare(scene, 0, expected.a);
        compare(scene, 1, expected.b);
        CHECK(check_of(scene, CheckType::event_count)->count == 1);
    }
    for (const char* name : {"mass_ratio_squeezed", "pi_by_impacts"}) {
        const Scene scene = stress_scene(name);
        const ShuttleEnd expected = shuttle_end(scene);
        compare(scene, 0, expected.states[0]);
        compare(scene, 1, expected.states[1]);
        CHECK(check_of(scene, CheckType::event_count)->count == expected.impacts);
    }
    for (const char* name : {"narrow_wedge_10", "narrow_wedge_1", "narrow_wedge_thousandth", "narrow_wedge_2e-5"}) {
        const Scene scene = stress_scene(name);
        const WedgeEnd expected = wedge_end(scene);
        compare(scene, 0, expected.state);
        CHECK(check_of(scene, CheckType::event_count)->count == expected.impacts);
    }
    for (const char* name : {"between_heavy_1", "between_heavy_0.9", "between_heavy_0.5"}) {
        const Scene scene = stress_scene(name);
        const std::array<Real, 3> expected = row_of_three(scene);
        for (const BodyId body : {0, 2}) {
            const Check* check = check_of(scene, CheckType::final_velocity, body);
            CHECK(std::abs(static_cast<double>(check->value.x() - expected[static_cast<std::size_t>(body)])) < 1e-12);
            CHECK(check->abs == 1e-9);
        }
    }
    const Scene leaning = stress_scene("towers_off_axis");
    for (BodyId lower = 0; lower < static_cast<BodyId>(leaning.spheres.size()); lower += 2) {
        const Real way = leaning_way(leaning, static_cast<std::size_t>(lower), static_cast<std::size_t>(lower) + 1);
        const Check *below = check_of(leaning, CheckType::final_position, lower),
                    *above = check_of(leaning, CheckType::final_position, lower + 1);
        CHECK(static_cast<double>((Real(above->value.x()) - Real(below->value.x())) / 2 / way) ==
              Approx(1).epsilon(1e-6));
        CHECK(static_cast<double>(*above->abs / way) == Approx(0.01).epsilon(1e-6));
    }
    const Scene speeds = stress_scene("speeds");
    const Meeting fast = meeting(speeds, 0, 1), slow = meeting(speeds, 2, 3);
    for (const auto& [body, state] : {std::pair{0, fast.a}, {1, fast.b}, {2, slow.a}, {3, slow.b}})
        compare(speeds, body, state);
    CHECK(check_of(speeds, CheckType::event_time)->time == slow.time);
    for (const char* name : {"ulp_gap_parting", "ulp_gap_abreast", "grazing_pass"}) {
        const Scene scene = stress_scene(name);
        for (BodyId body = 0; body < 2; ++body) {
            const Sphere& sphere = scene.spheres[static_cast<std::size_t>(body)];
            compare(scene, body, {sphere.position + scene.end_time * sphere.velocity, sphere.velocity});
        }
        CHECK(check_of(scene, CheckType::event_count)->count == 0);
    }
    for (const char* name : {"zeno_short", "zeno_long"}) {
        const Scene scene = stress_scene(name);
        const Real e = scene.materials[1].restitution, gravity = -Real(scene.gravity.z());
        const Real fall = std::sqrt(2 * (Real(scene.spheres[0].position.z()) - scene.spheres[0].radius) / gravity);
        CHECK(check_of(scene, CheckType::rest_time, 0)->time ==
              Approx(static_cast<double>(fall * (1 + e) / (1 - e))).epsilon(1e-15));
        Bouncing exact(static_cast<double>(gravity), static_cast<double>(fall), static_cast<double>(e));
        int heights = 0;
        for (const Check& check : scene.checks) {
            if (check.type != CheckType::position) continue;
            ++heights;
            INFO(scene.name << " at " << check.time);
            CHECK(std::abs(check.value.z() - scene.spheres[0].radius - exact.height(check.time)) < 1e-15);
        }
        CHECK(heights == 50);
    }
}
