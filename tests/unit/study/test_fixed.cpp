#include <carom/study.hpp>

#include "make_sphere.hpp"

#include <catch2/catch.hpp>

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
