#include <carom/checks.hpp>
#include <carom/study.hpp>

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;

TEST_CASE("balls that fall among fixed spheres: engine and reference agree, steppers come closer with their step",
          "[fixed]")
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.end_time = 1.2;
    scene.materials = {{"steel", 0.9, 1, ""}};
    const Vec3 pegs[]{{0, 0, 0}, {1.1, 0.1, -0.3}, {-0.9, -0.2, -0.6}, {0.3, 0.4, -1.5}};
    for (const Vec3& at : pegs) {
        scene.spheres.push_back(make_sphere("peg", 0.3, at));
        scene.spheres.back().id += std::to_string(scene.spheres.size());
        scene.spheres.back().fixed = true;
    }
    const Vec3 balls[]{{0.05, 0.02, 1}, {1.0, 0.2, 0.8}, {-0.8, -0.1, 1.4}};
    for (const Vec3& at : balls) {
        scene.spheres.push_back(make_sphere("ball", 0.15, at));
        scene.spheres.back().id += std::to_string(scene.spheres.size());
        scene.spheres.back().mass = 0.5 + at.z();
    }
    CompareOptions options;
    options.methods = {"event", "pbd", "velocity", "bisection"};
    options.dt = {1e-3, 1e-5};
    options.until = scene.end_time;
    options.repeats = 1;
    const Comparison result = compare_methods(scene, options);
    CHECK(result.reference.reason.empty());
    CHECK(result.reference.impacts >= 3);
    REQUIRE(result.rows.size() == 7);
    CHECK(result.rows[0].status == Status::reached_end);
    CHECK(*result.rows[0].position_max < 1e-12);
    CHECK(result.rows[0].missed_impacts == 0);
    CHECK(result.rows[0].invented_impacts == 0);
    for (std::size_t k = 1; k < result.rows.size(); k += 2) {
        CAPTURE(result.rows[k].method);
        CHECK(*result.rows[k + 1].position_max < *result.rows[k].position_max / 10);
    }
}

TEST_CASE("a ball falls off a bump that is sunk in the floor and comes to rest on the floor beside it", "[fixed]")
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81);
    scene.end_time = 3;
    scene.materials = {{"rubber", 0.5, 1, ""}};
    scene.planes.push_back({"floor", Vec3::UnitZ(), 0, std::nullopt, 0});
    scene.spheres.push_back(make_sphere("bump", 0.3, Vec3(0, 0, 0)));
    scene.spheres.push_back(make_sphere("side", 0.3, Vec3(-0.25, 0, -0.1)));  // sunk in the bump, too
    scene.spheres[0].fixed = scene.spheres[1].fixed = true;
    scene.spheres.push_back(make_sphere("ball", 0.2, Vec3(0.05, 0, 2)));
    scene.spheres.back().mass = 1;
    scene.checks.emplace_back();  // no_overlap
    REQUIRE(validate(scene).empty());

    std::vector<double> impacts;
    RunStudyOptions options;
    options.on_event = [&](const Event& event) {
        if (event.kind == EventKind::impact) impacts.push_back(event.time);
    };
    const RunStudy run = run_study(scene, EventDriven{}, options);
    CHECK(run.outcome.status == Status::reached_end);
    CHECK(run.max_penetration < 1e-15);
    CHECK(run.initial_energy == Approx(9.81 * 2).epsilon(1e-15));
    REQUIRE_FALSE(impacts.empty());
    // The centres are 0.3 + 0.2 apart, 0.05 across.
    const double top = std::sqrt(0.5 * 0.5 - 0.05 * 0.05);
    CHECK(impacts[0] == Approx(std::sqrt(2 * (2 - top) / 9.81)).epsilon(1e-14));
    const BodyState& ball = run.outcome.final[2];
    CHECK(ball.mode == Mode::sliding);
    CHECK(run.outcome.rest_times[2].has_value());
    CHECK(ball.position.z() == Approx(0.2).epsilon(1e-14));
    CHECK(ball.position.x() > std::sqrt(0.5 * 0.5 - 0.2 * 0.2));
    CHECK(check_scene(scene).all_hold());

    CompareOptions methods;
    methods.methods = method_names();
    methods.dt = {1e-3};
    methods.until = 0.3;  // in free fall: whoever overlaps overlaps by what cannot move
    methods.repeats = 1;
    for (const CompareRow& row : compare_methods(scene, methods).rows) {
        CAPTURE(row.method);
        CHECK(row.max_penetration == 0);
        CHECK(row.series.penetration == std::vector<double>(row.series.penetration.size(), 0.0));
    }
}
