#include "io/compare_files.hpp"
#include "io/events_csv.hpp"
#include "io/run_json.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace carom;
using nlohmann::json;

namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

Scene two_balls()
{
    Scene scene;
    scene.name = "Two, \"balls\"";
    for (const char* id : {"a", "b"}) {
        Sphere sphere;
        sphere.id = id;
        sphere.radius = 0.1;
        scene.spheres.push_back(sphere);
    }
    Plane floor;
    floor.id = "floor";
    scene.planes.push_back(floor);
    return scene;
}

RunStudy some_run()
{
    RunStudy run;
    run.method = "event";
    run.outcome.kernel = "gravity";
    run.outcome.time = 5;
    run.outcome.final.resize(2);
    run.outcome.final[1].mode = Mode::resting;
    run.outcome.rest_times = {std::nullopt, 4.063713};
    run.outcome.event_hash = 0x9f;
    run.outcome.counts.impacts = 21;
    run.plane_forces = {9.81};
    return run;
}

bool has_all(const json& object, std::initializer_list<const char*> keys)
{
    for (const char* key : keys)
        if (!object.contains(key)) {
            UNSCOPED_INFO("missing: " << key);
            return false;
        }
    return true;
}

}  // namespace

TEST_CASE("a run's JSON has every key of the contract", "[results]")
{
    const json run = json::parse(io::run_json(two_balls(), EventDriven{}, some_run()));
    CHECK(has_all(run,
                  {"format",         "scene",      "method",      "kernel",       "number",          "status",
                   "time",           "spheres",    "counts",      "energy",       "momentum",        "max_penetration",
                   "missed_impacts", "escaped",    "cpu_seconds", "wall_seconds", "command_seconds", "event_hash",
                   "pressure",       "rest_times", "final"}));
    CHECK(has_all(run["counts"], {"impacts", "clusters", "capped", "rests", "releases", "guarded", "settles",
                                  "cell_crossings", "list_rebuilds", "stale", "pair_tests", "root_solves"}));
    CHECK(has_all(run["energy"], {"initial", "final", "drag", "max_relative_drift"}));
    CHECK(has_all(run["final"][0], {"id", "position", "velocity", "mode"}));
    CHECK(run["format"] == "carom-run/1");
    CHECK(run["scene"] == "Two, \"balls\"");
    CHECK(run["number"] == "double");
    CHECK(run["status"] == "reached_end");
    CHECK(run["spheres"] == 2);
    CHECK(run["counts"]["impacts"] == 21);
    CHECK(run["momentum"]["initial"] == json({0.0, 0.0, 0.0}));
    CHECK(run["energy"]["max_relative_drift"].is_null());
    CHECK(run["missed_impacts"].is_null());
    CHECK(run["event_hash"] == "000000000000009f");
    CHECK(run["pressure"]["virial_z"].is_null());
    CHECK(run["pressure"]["planes"]["floor"] == 9.81);
    CHECK(run["rest_times"] == json({{"b", 4.063713}}));
    CHECK(run["final"][1]["mode"] == "resting");
}

TEST_CASE("a discrete run has no hash and no kernel, and says its step", "[results]")
{
    RunStudy study = some_run();
    study.outcome.kernel.clear();
    PositionBased pbd;
    pbd.dt = 0.01;
    const json run = json::parse(io::run_json(two_balls(), pbd, study));
    CHECK(run["event_hash"].is_null());
    CHECK(run["kernel"].is_null());
    CHECK(run["step"]["dt"] == 0.01);
}

TEST_CASE("what is not finite is null in JSON", "[results]")
{
    RunStudy study = some_run();
    study.outcome.final[0].position[1] = nan_value;
    study.final_energy = std::numeric_limits<double>::infinity();
    study.max_relative_drift = nan_value;
    const json run = json::parse(io::run_json(two_balls(), EventDriven{}, study));  // "nan" would not parse
    CHECK(run["final"][0]["position"][1].is_null());
    CHECK(run["energy"]["final"].is_null());
    CHECK(run["energy"]["max_relative_drift"].is_null());
}

TEST_CASE("a far scene's JSON has absolute and local positions, its origin and its start time", "[results]")
{
    Scene scene = two_balls();
    RunStudy study = some_run();
    study.outcome.final[1].position = Vec3(0.25, 0, 1);
    const json near = json::parse(io::run_json(scene, EventDriven{}, study));
    CHECK_FALSE(near["final"][1].contains("local"));
    CHECK_FALSE(near.contains("origin"));
    CHECK_FALSE(near.contains("start_time"));
    scene.origin = Vec3(1e9, 0, -1);
    scene.start_time = {1024, 0.5};
    const json far = json::parse(io::run_json(scene, EventDriven{}, study));
    CHECK(far["final"][1]["local"] == json({0.25, 0, 1}));
    CHECK(far["final"][1]["position"] == json({1000000000.25, 0, 0}));
    CHECK(far["origin"] == json({1e9, 0, -1}));
    CHECK(far["start_time"] == json({{"epoch", 1024}, {"offset", 0.5}}));
    CHECK(far["time"] == near["time"]);
    CHECK(far["event_hash"] == near["event_hash"]);
}

TEST_CASE("final states of many spheres are written when asked for", "[results]")
{
    Scene scene = two_balls();
    RunStudy study = some_run();
    scene.spheres.resize(1001, scene.spheres[0]);
    study.outcome.final.resize(1001);
    CHECK_FALSE(json::parse(io::run_json(scene, EventDriven{}, study)).contains("final"));
    CHECK(json::parse(io::run_json(scene, EventDriven{}, study, {true}))["final"].size() == 1001);
}

TEST_CASE("a run's text is the one that its own tree writes, whatever ids and numbers it has", "[results]")
{
    Scene scene = two_balls();
    RunStudy study = some_run();
    const std::vector<std::string> ids{"a", "back\\slash", "tab\t", "K\xc3\xb6rper", "fill-0/17", "\x7f"};
    const std::vector<double> numbers{
        0, -0.0, 1, 1e-4, 1e-5, 1e15, 1e16, 1e22, -123.456, 5e-324, 1.7976931348623157e308};
    scene.spheres.resize(ids.size(), scene.spheres[0]);
    study.outcome.final.resize(ids.size());
    study.outcome.rest_times.resize(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
        scene.spheres[i].id = ids[i];
        study.outcome.final[i].position = Vec3(numbers[i], numbers[i + 1], numbers[i + 2]);
        study.outcome.final[i].velocity = Vec3(numbers[i + 5], numbers[i + 4], numbers[i + 3]);
        study.outcome.rest_times[i] = numbers[i];
    }
    const auto is_its_own_dump = [&] {
        const std::string text = io::run_json(scene, EventDriven{}, study);
        return nlohmann::ordered_json::parse(text).dump(2) + "\n" == text;
    };
    CHECK(is_its_own_dump());
    scene.origin = Vec3(1e9, 0, 0);
    CHECK(is_its_own_dump());
    std::fill(study.outcome.rest_times.begin(), study.outcome.rest_times.end(), std::nullopt);
    study.outcome.final.clear();
    CHECK(is_its_own_dump());
}

TEST_CASE("the events file has the contract's columns, names and exact times", "[results]")
{
    std::ostringstream out;
    const Scene scene = two_balls();
    io::EventsCsv csv(out, scene, true);
    Event event;
    event.at = {1, 0.125};
    event.time = 1.125;
    event.a = 0;
    event.b = scene.plane_body(0);
    event.normal = Vec3(0, 0, 1);
    event.impulse = Vec3(0, -0.1, 3);
    csv.write(event);
    event.kind = EventKind::rest;
    event.b = 1;
    event.at = {std::int64_t{1} << 40, 0x1p-40};
    event.time = 0x1p40;
    csv.write(event);
    CHECK(out.str() ==
          "t,kind,a,b,nx,ny,nz,jx,jy,jz\n"
          "1.125,impact,a,floor,0,0,1,0,-0.1,3\n"
          "1099511627776.0000000000009094947017729282379150390625,rest,a,b,0,0,1,0,-0.1,3\n");
    CHECK(io::event_line(scene, event, false).substr(0, 14) == "1099511627776,");
}

TEST_CASE("compare.csv has exactly the contract's header and empty fields for what is not known", "[results]")
{
    Comparison comparison;
    CompareRow event;
    event.method = "event";
    event.cpu_seconds = event.cpu_min = event.cpu_max = 1e-5;
    event.position_max = 3e-15;
    CompareRow blown;
    blown.method = "pbd";
    blown.dt = 0.1;
    blown.substeps = 2;
    blown.passes = 1;
    blown.order = ContactOrder::deepest;
    blown.integrator = Integrator::parabola;
    blown.position_max = nan_value;
    blown.max_penetration = std::numeric_limits<double>::infinity();
    blown.missed_impacts = 7;
    blown.audit = Audit{10, 4, 3, 2, 1, 6, 100, 5, 0.5};
    blown.status = Status::unresolved;
    comparison.rows = {event, blown};
    CHECK(io::compare_csv(comparison) ==
          "method,dt,substeps,passes,order,integrator,impact,stiffness,hertz,damping_ratio,cpu_seconds,cpu_min,cpu_max,"
          "position_rms,position_max,position_final_rms,position_"
          "final_max,velocity_"
          "rms,energy_error,max_penetration,overlap_left,missed_impacts,invented_impacts,impacts,audited,found,late,"
          "missed,"
          "wrong,invented,crowded,absorbed,rest_jitter,divergence_time,reference_bound,steps,root_solves,pair_tests,"
          "status,peer_settings\n"
          "event,,,,,,,,,,1e-05,1e-05,1e-05,,3e-15,,,,,0,0,0,0,0,,,,,,,,,,,0,0,0,0,reached_end,\n"
          "pbd,0.1,2,1,deepest,parabola,,,,,0,0,0,,,,,,,,0,7,0,0,10,4,3,2,1,5,6,,,,0,0,0,0,unresolved,\n");
}

TEST_CASE("compare.json has the CSV's keys in each row, the reference and the verdict", "[results]")
{
    Comparison comparison;
    comparison.reference.kind = "multiprecision";
    comparison.verdict = {"One.", "Two."};
    CompareRow row;
    row.method = "pbd";
    row.position_rms = nan_value;
    row.missed = {{0.5, 0, 2}};
    row.audit = Audit{20, 20, 0, 0, 0, 6, 0, 0, 0.5};
    comparison.rows = {row};
    const json parsed = json::parse(io::compare_json(two_balls(), comparison));
    CHECK(has_all(parsed, {"format", "scene", "reference", "rows", "verdict", "command_seconds", "stopped"}));
    CHECK(has_all(parsed["reference"], {"kind", "bound", "until", "reason"}));
    CHECK(parsed["format"] == "carom-compare/1");
    CHECK(parsed["verdict"] == "One. Two.");
    std::istringstream header(io::compare_csv_header());
    for (std::string key; std::getline(header, key, ',');) {
        CAPTURE(key);
        CHECK(parsed["rows"][0].contains(key));
    }
    CHECK(parsed["rows"][0]["position_rms"].is_null());
    CHECK(parsed["rows"][0]["dt"].is_null());
    CHECK(parsed["rows"][0]["missed_at"][0] == json({{"time", 0.5}, {"a", "a"}, {"b", "floor"}}));
    CHECK(parsed["rows"][0]["found"] == 20);
    CHECK(parsed["rows"][0]["audit"]["found"][1] == Approx(1 - 0.1611).margin(5e-5));  // Wilson's interval for 0 of 20
    CHECK(parsed["rows"][0]["audit"]["invented"].is_null());                           // of none
    CHECK(has_all(parsed["audit"], {"until", "contacts", "drawn", "phases", "slow", "persistent"}));
}
