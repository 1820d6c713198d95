#include "study/stress/case.hpp"
#include "study/stress/scenes.hpp"
#include "study/stress/shuttle.hpp"
#include "study/stress/two_spheres.hpp"

#include <carom/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <set>

using namespace carom;
using namespace carom::stress;
using Catch::Matchers::Contains;

namespace {

Report run_one(const std::string& name, const std::vector<std::string>& methods)
{
    Options options;
    options.methods = methods;
    options.only = name;
    return run_cases(options);
}

}  // namespace

TEST_CASE("stress: there are twelve cases, and event passes each of them", "[stress]")
{
    const std::vector<std::string> names = case_names();
    CHECK(names == std::vector<std::string>{"mass_ratio", "radius_ratio", "speed", "gravity", "far_origin",
                                            "start_time", "ulp_gap", "grazing", "counting_pi", "zeno", "time_reversal",
                                            "drift"});
    for (const std::string& each : names) {
        const Report report = run_one(each, {"event"});
        REQUIRE(report.cases.size() == 1);
        const Result& result = report.cases[0].results.at(0);
        INFO(each << ": " << result.figure << " " << result.reason);
        CHECK(result.passed);
        CHECK(result.figure <= result.limit);
        CHECK(report.event_passes());
    }
}

TEST_CASE("stress: each case can be failed, and says why", "[stress]")
{
    // start_time has none: a run of ours counts from its start, so no method sees the clock.
    const std::map<std::string, std::pair<std::string, Symptom>> controls{
        {"mass_ratio", {"velocity", Symptom::late}}, {"radius_ratio", {"pbd", Symptom::sank}},
        {"speed", {"bisection", Symptom::missed}},   {"gravity", {"naive", Symptom::invented}},
        {"far_origin", {"pbd", Symptom::late}},      {"ulp_gap", {"naive", Symptom::invented}},
        {"grazing", {"velocity", Symptom::missed}},  {"counting_pi", {"naive", Symptom::sank}},
        {"zeno", {"naive", Symptom::sank}},          {"time_reversal", {"pbd", Symptom::late}},
        {"drift", {"velocity", Symptom::energy}},
    };
    for (const auto& [name, control] : controls) {
        const Report report = run_one(name, {control.first});
        const Result& result = report.cases.at(0).results.at(0);
        INFO(name << " " << control.first << ": " << result.figure << " " << result.reason);
        CHECK_FALSE(result.passed);
        CHECK(stress::name(result.symptom) == std::string(stress::name(control.second)));
        CHECK_THAT(result.reason, Contains(": "));  // numbers, then the cause
        CHECK(report.event_passes());               // it was not asked for
    }
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
    bad.same_run = false;
    CHECK(diagnose(bad, 1) == Symptom::other_run);
    bad.stopped = "why";
    CHECK(diagnose(bad, 1) == Symptom::stopped);
    good.same_run = false;  // another hash fails, however small the differences
    CHECK(diagnose(good, 0.01) == Symptom::other_run);
}

TEST_CASE("stress: event failing a case fails the report, another method does not", "[stress]")
{
    Report report;
    report.methods = {"event", "pbd"};
    CaseResult c;
    c.results = {Result{.method = "event", .passed = true}, Result{.method = "pbd"}};
    report.cases = {c};
    CHECK(report.event_passes());
    report.cases[0].results[0].passed = false;
    CHECK_FALSE(report.event_passes());
}

TEST_CASE("stress: unknown names are refused, and an interruption ends it", "[stress]")
{
    CHECK_THROWS_WITH(run_one("grasing", {}), Contains("grasing") && Contains("grazing"));
    CHECK_THROWS_AS(run_one("grazing", {"magic"}), InputError);
    Options options;
    options.methods = {"event"};
    options.on_progress = [&](const Progress& now) { return now.amount < 1; };
    const Report report = run_cases(options);
    CHECK(report.interrupted);
    CHECK(report.cases.size() == 1);
}

TEST_CASE("stress: the shuttle counts the digits of pi", "[stress]")
{
    // Galperin 2003: with masses 100^k : 1 there are floor(10^k pi) impacts.
    const std::int64_t digits[] = {3, 31, 314, 3141, 31415};
    long double mass = 1;
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
    Scene scene = empty_scene("Two", 2);
    // The contact normal makes 30 degrees with the path: sin = 1/2 of the contact distance.
    add_sphere(scene, {.radius = 0.25, .mass = 3, .position = {-1, 0.25, 0}, .velocity = {1, 0, 0}});
    add_sphere(scene, {.radius = 0.25, .mass = 1});
    const Meeting m = meeting(scene, 0, 1);
    CHECK(m.time == Approx(1 - 0.5 * std::sqrt(0.75)).epsilon(1e-15));
    // The struck sphere leaves along the normal at 2 m_a/(m_a + m_b) cos 30 degrees.
    const double leaving = 1.5 * std::sqrt(0.75);
    CHECK(m.b.velocity.x() == Approx(leaving * std::sqrt(0.75)).epsilon(1e-15));
    CHECK(m.b.velocity.y() == Approx(-leaving * 0.5).epsilon(1e-15));
    CHECK((3 * m.a.velocity + m.b.velocity - Vec3(3, 0, 0)).norm() < 1e-15);
    CHECK((m.b.position - (2 - m.time) * m.b.velocity).norm() < 1e-15);
}
