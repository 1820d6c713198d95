#include <carom/checks.hpp>

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace carom;
using Catch::Contains;

namespace {

Check check_of(CheckType type, std::optional<double> abs = {})
{
    Check check;
    check.type = type;
    check.abs = abs;
    return check;
}

/// One metre above a floor, e = 0.8: impacts at 0.4515 and 1.174 s.
Scene dropped_ball(const std::vector<Check>& checks)
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.end_time = 1.5;
    scene.materials = {{"rubber", 0.8, 1, ""}};
    scene.spheres.push_back(make_sphere("ball", 0.1, Vec3(0, 0, 1.1)));
    Plane floor;
    floor.id = "floor";
    scene.planes.push_back(floor);
    scene.checks = checks;
    return scene;
}

CheckResult result_of(const Check& check)
{
    const CheckReport report = check_scene(dropped_ball({check}));
    REQUIRE(report.results.size() == 1);
    return report.results[0];
}

const double first_impact = std::sqrt(2 / 9.81);

/// From t = 1 on a light ball is squeezed between a fixed and a heavy one: impacts accumulate, and the guard is off.
Scene squeezed(const std::vector<Check>& checks)
{
    Scene scene;
    scene.end_time = 3;
    scene.materials[0].restitution = 0.99;
    scene.guard.on = false;
    scene.guard.impacts = 1;
    scene.rest.closing_speed = scene.rest.window = 0;
    scene.rest.numeric_step = 1e-2;
    scene.spheres.push_back(make_sphere("fixed", 0.5, Vec3(0, 0, 0)));
    scene.spheres.back().fixed = true;
    scene.spheres.push_back(make_sphere("light", 0.1, Vec3(0.6005, 0, 0)));
    scene.spheres.back().mass = 1e-6;
    scene.spheres.push_back(make_sphere("heavy", 0.5, Vec3(2.2005, 0, 0)));
    scene.spheres.back().mass = 1e6;
    scene.spheres.back().velocity = Vec3(-1, 0, 0);
    scene.spheres.push_back(make_sphere("other", 0.5, Vec3(0, 9, 0)));
    scene.spheres.push_back(make_sphere("third", 0.5, Vec3(1.5, 9, 0)));
    scene.spheres.back().velocity = Vec3(-1, 0, 0);
    scene.checks = checks;
    return scene;
}

}  // namespace

TEST_CASE("event_time holds within its tolerance and fails beyond it", "[checks]")
{
    Check check = check_of(CheckType::event_time, 1e-12);
    check.time = first_impact;
    CHECK(result_of(check).verdict == CheckVerdict::holds);
    check.time += 1e-6;
    const CheckResult off = result_of(check);
    CHECK(off.verdict == CheckVerdict::fails);
    CHECK(*off.error == Approx(1e-6).epsilon(1e-6));
    CHECK_THAT(off.message, Contains("expected 0.45152"));
    check.abs.reset();
    check.rel = 1e-5;
    CHECK(result_of(check).verdict == CheckVerdict::holds);
    check.index = 1;
    check.time = first_impact * (1 + 2 * 0.8);
    check.rel = 1e-13;
    CHECK(result_of(check).verdict == CheckVerdict::holds);
    check.index = 2;
    const CheckResult none = result_of(check);
    CHECK(none.verdict == CheckVerdict::fails);
    CHECK_THAT(none.message, Contains("there are only 2 impacts"));
}

TEST_CASE("event_count counts the kind it names", "[checks]")
{
    Check check = check_of(CheckType::event_count);
    check.count = 2;
    CHECK(result_of(check).verdict == CheckVerdict::holds);
    check.count = 3;
    CHECK(result_of(check).verdict == CheckVerdict::fails);
    check.abs = 1;
    CHECK(result_of(check).verdict == CheckVerdict::holds);
    check.abs.reset();
    check.kind = EventKind::rest;
    check.count = 0;
    CHECK(result_of(check).verdict == CheckVerdict::holds);
}

TEST_CASE("rest_time fails where a sphere did not come to rest, and holds where it did", "[checks]")
{
    Check check = check_of(CheckType::rest_time, 1e-11);
    check.body = 0;
    check.time = 9 * first_impact;
    CHECK(result_of(check).verdict == CheckVerdict::fails);
    Scene scene = dropped_ball({check});
    scene.end_time = 5;
    CHECK(check_scene(scene).all_hold());
    scene.checks[0].time += 1e-3;
    CHECK(check_scene(scene).any_fails());
}

TEST_CASE("final states are compared as vectors", "[checks]")
{
    Scene scene;
    scene.end_time = 2;
    scene.origin = Vec3(1e9, 0, 0);
    scene.spheres.push_back(make_sphere("ball", 1));
    scene.spheres[0].velocity = Vec3(3, 4, 0);
    Check position = check_of(CheckType::final_position, 1e-15), velocity = check_of(CheckType::final_velocity, 1e-15);
    position.body = velocity.body = 0;
    position.value = Vec3(6, 8, 0);  // relative to the origin
    velocity.value = Vec3(3, 4, 0);
    scene.checks = {position, velocity};
    CHECK(check_scene(scene).all_hold());
    scene.checks[0].value = Vec3(6, 8, 1e-3);
    scene.checks[1].value = -velocity.value;
    const CheckReport report = check_scene(scene);
    CHECK(*report.results[0].error == Approx(1e-3));
    CHECK(*report.results[1].error == Approx(10));
    CHECK(report.any_fails());
    scene.checks[0].abs.reset();
    scene.checks[0].rel = 1.1e-4;
    CHECK(check_scene(scene).results[0].verdict == CheckVerdict::holds);
}

TEST_CASE("energy, momentum, overlap and walls hold for a free flight", "[checks]")
{
    Scene scene = dropped_ball(
        {check_of(CheckType::no_overlap), check_of(CheckType::energy, 1e-12), check_of(CheckType::inside)});
    scene.end_time = 0.4;
    CHECK(check_scene(scene).all_hold());
    scene.end_time = 1;  // a bounce takes 36 % of 9.81 J
    const CheckReport bounced = check_scene(scene);
    CHECK(bounced.results[0].verdict == CheckVerdict::holds);
    CHECK(bounced.results[1].verdict == CheckVerdict::fails);
    CHECK(*bounced.results[1].error == Approx(0.36 * 9.81));
    CHECK_THAT(bounced.results[1].message, Contains("some contacts take energy"));
    Scene falling = dropped_ball({check_of(CheckType::momentum, 1e-12)});
    CHECK(check_scene(falling).any_fails());
    falling.gravity = Vec3::Zero();
    CHECK(check_scene(falling).all_hold());
}

TEST_CASE("checks judge the figures of a run, whoever made it", "[checks]")
{
    Scene scene =
        dropped_ball({check_of(CheckType::no_overlap), check_of(CheckType::inside), check_of(CheckType::energy, 1)});
    CheckedRun run;
    run.study.outcome.final = initial_states(scene);
    run.study.outcome.rest_times.resize(1);
    run.study.max_penetration = 2e-10;  // more than 1e-9 of the radius
    run.study.escaped = 1;
    run.study.max_energy_change = std::numeric_limits<double>::quiet_NaN();
    const std::vector<CheckResult> results = evaluate_checks(scene, run);
    for (const CheckResult& each : results) CHECK(each.verdict == CheckVerdict::fails);
    run.study.max_penetration = 0.5e-10;
    run.study.escaped = 0;
    run.study.max_energy_change = 1;
    for (const CheckResult& each : evaluate_checks(scene, run)) CHECK(each.verdict == CheckVerdict::holds);
}

TEST_CASE("a run that ends early leaves open what needs its end, and judges what came before", "[checks]")
{
    Check first = check_of(CheckType::event_time, 1e-12), later = first, count = check_of(CheckType::event_count),
          place = check_of(CheckType::final_position, 1);
    first.time = 0.5;
    later.index = 5000;
    count.kind = EventKind::rest;
    count.count = 3;
    place.body = 0;
    Scene scene =
        squeezed({first, later, count, place, check_of(CheckType::no_overlap), check_of(CheckType::momentum, 1)});
    const CheckReport report = check_scene(scene);
    CHECK(report.run.study.outcome.status == Status::unresolved);
    CHECK(report.results[0].verdict == CheckVerdict::holds);
    for (std::size_t k = 1; k < report.results.size(); ++k) {
        CAPTURE(report.results[k].what);
        CHECK(report.results[k].verdict == CheckVerdict::open);
        CHECK_THAT(report.results[k].message, Contains("the run ended unresolved at t = 1"));
    }
    CHECK_FALSE(report.any_fails());
    CHECK_FALSE(report.all_hold());
    scene.checks[0].time = 0.4;  // what came before still counts
    CHECK(check_scene(scene).any_fails());
    scene.checks = {count};
    scene.checks[0].kind = EventKind::impact;
    scene.checks[0].count = 0;  // there was one already
    CHECK(check_scene(scene).any_fails());
}

TEST_CASE("event_time counts the impacts of two bodies where it names them", "[checks]")
{
    // The middle ball meets the right one, stops, and waits for the left one.
    Scene scene;
    scene.end_time = 10;
    scene.spheres = {make_sphere("left", 0.5, Vec3(-3, 0, 0)), make_sphere("middle", 0.5, Vec3(0, 0, 0)),
                     make_sphere("right", 0.5, Vec3(2, 0, 0))};
    scene.spheres[1].velocity = Vec3(1, 0, 0);
    scene.spheres[0].velocity = Vec3(0.25, 0, 0);
    Check check = check_of(CheckType::event_time, 1e-15);
    check.between = {1, 0};  // in either order
    check.time = 12;         // the middle one rests at x = 1 from t = 1 on, 3 m from contact with the left one
    scene.checks = {check};
    CHECK(check_scene(scene).results[0].verdict == CheckVerdict::fails);
    CHECK_THAT(check_scene(scene).results[0].message, Contains("no such impact"));
    scene.end_time = 13;
    const CheckReport report = check_scene(scene);
    CHECK(report.results[0].verdict == CheckVerdict::holds);
    CHECK(report.results[0].what == "event_time 0 of middle and left");
    scene.checks[0].between.reset();
    scene.checks[0].time = 1;
    CHECK(check_scene(scene).all_hold());
}

TEST_CASE("position looks at a place on the way", "[checks]")
{
    Check check = check_of(CheckType::position, 1e-15);
    check.body = 0;
    check.time = 0.3;
    check.value = Vec3(0, 0, 1.1 - 9.81 * 0.3 * 0.3 / 2);
    const CheckResult held = result_of(check);
    CHECK(held.verdict == CheckVerdict::holds);
    CHECK(held.what == "position ball at 0.3");
    check.value.x() = 1e-3;
    CHECK(*result_of(check).error == Approx(1e-3));
    check.time = 1.6;
    CHECK(result_of(check).verdict == CheckVerdict::fails);  // the run is over
}

TEST_CASE("final_energy does not see what came back", "[checks]")
{
    Scene scene = dropped_ball({check_of(CheckType::final_energy, 1e-12)});
    CHECK(check_scene(scene).any_fails());
    scene.end_time = 0.4;
    CHECK(check_scene(scene).all_hold());
}

namespace {

/// Four balls in a box, of which a stepper makes another run 1e9 m away.
Scene small_gas(CheckType type)
{
    Scene scene;
    scene.end_time = 4;
    for (int k = 0; k < 4; ++k) {
        scene.spheres.push_back(make_sphere(("ball-" + std::to_string(k)).c_str(), 0.25, Vec3(k, 0.25 * k, 0.125)));
        scene.spheres.back().velocity = Vec3(1 - k, 0.5, 0.25 * k);
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {1, -1}) {
            Plane wall;
            wall.id = "wall-" + std::to_string(2 * axis + side);
            wall.normal = side * Vec3::Unit(axis);
            wall.offset = -4;
            scene.planes.push_back(wall);
        }
    }
    Check check = check_of(type, 0);
    check.value = Vec3(1e9, 1e9, 1e9);
    check.time = 0x1p40;
    if (type == CheckType::reversed) check.abs = 1e-12;
    scene.checks = {check};
    return scene;
}

}  // namespace

TEST_CASE("event is the same elsewhere, later and backwards, and steppers need not be", "[checks]")
{
    for (const CheckType type : {CheckType::moved, CheckType::moved_origin, CheckType::later, CheckType::reversed}) {
        const Scene scene = small_gas(type);
        const CheckReport report = check_scene(scene);
        INFO(report.results[0].what << ": " << report.results[0].message);
        CHECK(report.all_hold());
        CHECK(report.run.study.outcome.counts.impacts > 0);
        CheckOptions stepper;
        stepper.method = PositionBased{StepOptions{.dt = 1.0 / 240}};
        CHECK(check_scene(scene, stepper).all_hold() == (type == CheckType::later));
    }
}

TEST_CASE("a state that is its own mirror image holds, one that is not says by how much", "[checks]")
{
    Scene scene;
    scene.end_time = 1;
    scene.spheres.resize(3);
    const Vec3 normal(0, 2, 0);  // of any length
    for (std::size_t i = 0; i < 3; ++i) {
        scene.spheres[i].id = std::to_string(i);
        scene.spheres[i].radius = 0.5;
        scene.spheres[i].position = Vec3(static_cast<double>(i == 2), i == 2 ? 0 : i == 0 ? 2 : -2, 7);
        scene.spheres[i].velocity = Vec3(1, i == 2 ? 0 : i == 0 ? 1 : -1, 3);
    }
    Check check = check_of(CheckType::mirrored, 0);
    check.value = normal;
    check.abs = 1e-12;
    scene.checks = {check};
    CHECK(validate(scene).empty());
    CHECK(check_scene(scene).all_hold());
    scene.spheres[0].position.y() += 0.125;  // a quarter of a radius, seen from either side
    CheckResult off = check_scene(scene).results[0];
    CHECK(off.verdict == CheckVerdict::fails);
    CHECK(*off.error == Approx(0.25));
    scene.spheres[0].position.y() -= 0.125;
    scene.spheres[0].velocity.y() = -1;
    off = check_scene(scene).results[0];
    CHECK(off.verdict == CheckVerdict::fails);
    scene.checks[0].value = Vec3::Zero();
    CHECK_FALSE(validate(scene).empty());
}

TEST_CASE("a run elsewhere that is another one fails, however near its end", "[checks]")
{
    const Scene scene = small_gas(CheckType::moved);
    CheckedRun run;
    run.study.outcome.final = initial_states(scene);
    run.sights.resize(1);
    Repeat& repeat = run.sights[0].repeat.emplace();
    CHECK(evaluate_checks(scene, run)[0].verdict == CheckVerdict::holds);
    repeat.difference = std::numeric_limits<double>::infinity();
    repeat.other_events = true;
    CHECK(evaluate_checks(scene, run)[0].verdict == CheckVerdict::fails);
    CHECK_THAT(evaluate_checks(scene, run)[0].message, Contains("other events"));
    repeat.outcome.status = Status::time_limit;
    CHECK_THAT(evaluate_checks(scene, run)[0].message, Contains("ended time_limit"));
}

TEST_CASE("an interruption during the second run ends the check", "[checks]")
{
    Scene scene = small_gas(CheckType::later);
    double reached = 0;
    CheckOptions options;
    options.on_progress = [&](double time) {
        const bool second = time < reached;
        reached = time;
        return !second;
    };
    scene.end_time = 2000;  // long enough to be asked now and then
    CHECK(check_scene(scene, options).run.study.outcome.status == Status::interrupted);
}
