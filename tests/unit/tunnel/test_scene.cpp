#include "support/scenes.hpp"
#include "tunnel/judge.hpp"
#include "tunnel/scene_throws.hpp"
#include "tunnel/summary.hpp"
#include "unit/tunnel/binomial.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;
using namespace carom::tunnel;

namespace {

Matrix asked(std::vector<double> speed)
{
    Matrix matrix;
    matrix.speed = std::move(speed);
    matrix.dt = {0.01};
    return matrix;
}

Report thrown(const Scene& scene, const Matrix& matrix, const char* method)
{
    Report report;
    run_scene(scene, matrix, {contestant(method)}, report, {});
    return report;
}

/// A ball of radius 0.1 that comes along x at something with its middle at x = 5, and a slower one far away.
Scene ball()
{
    Scene scene = empty_scene(10);
    add_sphere(scene, 0.1, {0, 0, 0}, {2, 0, 0});
    add_sphere(scene, 0.1, {0, 50, 0}, {1, 0, 0});
    return scene;
}

}  // namespace

TEST_CASE("the fastest body of a scene is missed by the law at a plate, a fixed sphere and a box wall", "[tunnel]")
{
    Scene plate = ball(), sphere = ball(), wall = ball();
    add_plane(plate, "plate", {1, 0, 0}, 5);
    plate.planes[0].thickness = 0.02;
    add_sphere(sphere, 0.01, {5, 0, 0.06});
    sphere.spheres[2].fixed = true;
    add_plane(wall, "box+x", {-1, 0, 0}, -5);
    const double chords[] = {0.11, std::sqrt(0.11 * 0.11 - 0.06 * 0.06)};
    for (const double speed : {5.0, 30.0, 700.0}) {
        const Row at_plate = thrown(plate, asked({speed}), "velocity").rows.at(0);
        CHECK(at_plate.cell.target == Target::plate);
        CHECK(at_plate.cell.thickness == 0.02);
        CHECK(at_plate.cell.radius == 0.1);
        CHECK(binomial_p(at_plate.tunnelled, at_plate.trials, std::max(0.0, 1 - chords[0] / (speed * 0.01))) >= 1e-6);
        const Row at_sphere = thrown(sphere, asked({speed}), "velocity").rows.at(0);
        CHECK(at_sphere.cell.target == Target::sphere);
        CHECK(binomial_p(at_sphere.tunnelled, at_sphere.trials, std::max(0.0, 1 - chords[1] / (speed * 0.01))) >= 1e-6);
        const Row at_wall = thrown(wall, asked({speed}), "velocity").rows.at(0);
        CHECK(at_wall.cell.target == Target::wall);
        CHECK(at_wall.tunnelled + at_wall.wrong == 0);
        for (const Row& row : {at_plate, at_sphere, at_wall}) CHECK(row.trials == 1000);
        CHECK(at_plate.law.value() == Approx(std::max(0.0, 1 - chords[0] / (speed * 0.01))));
        CHECK(at_sphere.law.value() == Approx(std::max(0.0, 1 - chords[1] / (speed * 0.01))));
        CHECK(at_wall.law.value() == 0);
    }
}

TEST_CASE("a plate that is hit at a slant is seen as long as the speed along its normal says", "[tunnel]")
{
    Scene scene = ball();
    add_plane(scene, "slanted", {0.6, 0.8, 0}, 3);
    scene.planes[0].thickness = 0.02;
    const Row row = thrown(scene, asked({40}), "velocity").rows.at(0);
    const double law = 1 - 0.11 / (0.6 * 40 * 0.01);
    CHECK(row.law.value() == Approx(law));
    CHECK(binomial_p(row.tunnelled, row.trials, law) >= 1e-6);
}

TEST_CASE("gravity bends the way to the contact, and toi with parabolas follows it", "[tunnel]")
{
    Scene scene = empty_scene(5, earth);
    add_sphere(scene, 0.1, {0, 0, 2}, {0, 0, -1});
    add_plane(scene, "floor", {0, 0, 1});
    StepOptions step;
    step.integrator = Integrator::parabola;
    Report report;
    run_scene(scene, asked({0.5, 3, 100}), {contestant("toi", step)}, report, {});
    REQUIRE(report.rows.size() == 3);
    for (const Row& row : report.rows) {
        CHECK(row.trials == 1000);
        CHECK(row.tunnelled + row.wrong == 0);
        CHECK(row.worst_error.value() < 1e-12);
        CHECK_FALSE(row.law);
    }
}

TEST_CASE("a body slowed down is watched longer, and one that meets nothing is said so", "[tunnel]")
{
    Scene scene = ball();
    scene.end_time = 3;  // at its own speed it is there at 2.44
    add_plane(scene, "plate", {1, 0, 0}, 5);
    scene.planes[0].thickness = 0.02;
    CHECK(thrown(scene, asked({0.5}), "velocity").rows.size() == 1);
    const Report nothing = thrown(ball(), asked({3}), "velocity");
    CHECK(nothing.rows.empty());
    REQUIRE(nothing.absent.size() == 1);
    CHECK(nothing.absent[0].name == "speed 3");
    CHECK(nothing.absent[0].reason.find("\"s0\" meets nothing") == 0);
}

TEST_CASE("throws whose bodies have another contact within the steps are not judged", "[tunnel]")
{
    Scene scene = ball();
    add_plane(scene, "near", {-1, 0, 0}, -5);
    add_plane(scene, "far", {1, 0, 0}, 4.7);  // 0.1 of way between contacts: at 100 a step crosses it ten times
    scene.spheres[0].position = {4.85, 0, 0};
    CHECK(thrown(scene, asked({100}), "velocity").rows.at(0).trials == 0);
    CHECK(thrown(scene, asked({0.01}), "velocity").rows.at(0).trials == 1000);
}

TEST_CASE("a scene in which nothing moves has no speed to scale", "[tunnel]")
{
    Scene scene = empty_scene(1, earth);
    add_sphere(scene, 0.1, {0, 0, 2});
    CHECK_FALSE(some_body_moves(scene));
    CHECK(some_body_moves(ball()));
}

TEST_CASE("critical speeds of a scene are those of the law at a plate, a slanted one, and a fixed sphere", "[tunnel]")
{
    Matrix matrix;
    matrix.dt = {0.01};
    const auto found = [&](const Scene& scene, const char* method) {
        Report report;
        find_scene_criticals(scene, matrix, {contestant(method)}, report, {});
        REQUIRE(report.criticals.size() == 1);
        CHECK(report.criticals[0].law.value_or(0) > 0);
        return report.criticals[0];
    };
    Scene plate = ball(), slanted = ball(), sphere = ball();
    add_plane(plate, "plate", {1, 0, 0}, 5);
    plate.planes[0].thickness = 0.02;
    add_plane(slanted, "slanted", {0.6, 0.8, 0}, 3);
    slanted.planes[0].thickness = 0.02;
    add_sphere(sphere, 0.01, {5, 0, 0.06});
    sphere.spheres[2].fixed = true;
    CHECK(found(plate, "velocity").speed.speed == Approx(11).epsilon(0.02));
    CHECK(found(plate, "velocity").law.value() == Approx(11));
    CHECK(found(slanted, "velocity").speed.speed == Approx(11 / 0.6).epsilon(0.02));
    CHECK(found(slanted, "velocity").law.value() == Approx(11 / 0.6));
    CHECK(found(sphere, "velocity").speed.speed == Approx(100 * std::sqrt(0.0121 - 0.0036)).epsilon(0.02));
    CHECK(found(plate, "toi").speed.end == CriticalSpeed::End::never);
}

TEST_CASE("at a wall of a scene nothing is critical, and that is said", "[tunnel]")
{
    Scene scene = ball();
    add_plane(scene, "box+x", {-1, 0, 0}, -5);
    Report report;
    find_scene_criticals(scene, asked({1}), {contestant("velocity")}, report, {});
    CHECK(report.criticals.empty());
    REQUIRE(report.absent.size() == 1);
    CHECK(report.absent[0].reason == "\"s0\" meets a wall first: nothing is behind it");
}

TEST_CASE("the throw that shows a row of a scene begins a part of a step before the contact, and is missed again",
          "[tunnel]")
{
    Scene scene = ball();
    add_plane(scene, "plate", {1, 0, 0}, 5);
    scene.planes[0].thickness = 0.02;
    const Row row = thrown(scene, asked({300}), "velocity").rows.at(0);
    REQUIRE(row.tunnelled > 0);
    const Throw t = example_of(row);
    CHECK(t.scene.spheres[0].position.x() == Approx(5 - 0.11 - row.example.phase * 3).epsilon(1e-12));
    CHECK(judge(contestant("velocity"), t, 0.01).fate == Fate::tunnelled);
    CHECK(judge(contestant("toi"), t, 0.01).fate == Fate::hit);
}

TEST_CASE("the verdict on a scene with gravity tells both integrators by themselves", "[tunnel]")
{
    Scene scene = empty_scene(5, earth);
    add_sphere(scene, 0.1, {0, 0, 2}, {0, 0, -1});
    add_plane(scene, "floor", {0, 0, 1});
    scene.planes[0].thickness = 0.02;
    StepOptions parabola;
    parabola.integrator = Integrator::parabola;
    Report report;
    run_scene(scene, asked({3, 100}), {contestant("toi"), contestant("toi", parabola)}, report, {});
    int euler = 0, exact = 0;
    for (const std::string& sentence : verdict(report)) {
        euler += sentence.starts_with("toi, euler: ");
        exact += sentence.starts_with("toi, parabola: none of the throws tunnelled, none were answered late");
    }
    CHECK(euler == 1);
    CHECK(exact == 1);
}
