#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("a sphere slides g sin(theta) t^2 / 2 down a frictionless incline, without events")
{
    for (const double theta : {0.1, 0.5, 1.2}) {
        Scene scene = empty_scene(2, earth, 0.3);
        const Vec3 normal(std::sin(theta), 0, std::cos(theta)), down(std::cos(theta), 0, -std::sin(theta));
        add_plane(scene, "incline", normal);
        add_sphere(scene, 0.1, 0.1 * scene.planes[0].normal, Vec3::Zero(), 3);
        const Recorded run = record(scene);
        INFO("theta " << theta);
        CHECK(run.events.empty());
        CHECK(run.outcome.final[0].mode == Mode::sliding);
        const Vec3 path = run.outcome.final[0].position - scene.spheres[0].position;
        const double length = 0.5 * 9.81 * std::sin(theta) * 4;
        CHECK((path - length * down).norm() <= 1e-14 * length);
        CHECK((run.outcome.final[0].velocity - 9.81 * std::sin(theta) * 2 * down).norm() <= 1e-13);
        CHECK(run.outcome.plane_impulses[0] == Approx(3 * 9.81 * std::cos(theta) * 2).epsilon(1e-13));
    }
}

TEST_CASE("a sphere dropped on an incline bounces down it, comes to normal rest and slides on")
{
    const double theta = 0.5, e = 0.5, height = 0.3;
    Scene scene = empty_scene(3, earth, e);
    add_plane(scene, "incline", {std::sin(theta), 0, std::cos(theta)});
    add_sphere(scene, 0.1, (0.1 + height) * scene.planes[0].normal);
    const Recorded run = record(scene);
    // Along the normal a drop under g cos(theta), along the incline a fall under g sin(theta), independent of each
    // other.
    const double fall = std::sqrt(2 * height / (9.81 * std::cos(theta)));
    REQUIRE(run.outcome.rest_times[0].has_value());
    CHECK(*run.outcome.rest_times[0] == Approx(fall * (1 + e) / (1 - e)).epsilon(1e-12));
    CHECK(run.outcome.final[0].mode == Mode::sliding);
    const Vec3 down(std::cos(theta), 0, -std::sin(theta));
    const Vec3 expected = 0.1 * scene.planes[0].normal + 0.5 * 9.81 * std::sin(theta) * 9 * down;
    CHECK((run.outcome.final[0].position - expected).norm() <= 1e-12);
}

TEST_CASE("a sphere that slides on a level floor into a wall comes back at e v, both contacts kept apart")
{
    Scene scene = empty_scene(5, earth, 0.5);
    add_floor(scene);
    add_plane(scene, "wall", -Vec3::UnitX(), -2);
    add_sphere(scene, 0.5, {0, 0, 0.5}, {1, 0, 0});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.events.size() == 1);
    CHECK(run.events[0].time == 1.5);
    CHECK(run.events[0].b == 2);
    CHECK(run.events[0].impulse == Vec3(-1.5, 0, 0));
    CHECK(run.outcome.final[0].velocity == Vec3(-0.5, 0, 0));
    CHECK(run.outcome.final[0].position == Vec3(1.5 - 0.5 * 3.5, 0, 0.5));
    CHECK(run.outcome.final[0].mode == Mode::sliding);
    CHECK(run.outcome.plane_impulses[0] == Approx(9.81 * 5).epsilon(1e-14));
}

TEST_CASE("alpha = 0.5 slows what bounces: each impact halves the tangential speed")
{
    Scene scene = empty_scene(3, earth, 1);
    scene.materials[0].tangential = 0.5;
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 1.1}, {1, 0, 0});
    const Recorded run = record(scene);
    double speed = 1, x = 0, last = 0;
    for (const Event& event : run.events) {
        x += speed * (event.time - last);
        last = event.time;
        speed *= 0.5;
        CHECK(event.impulse.x() == Approx(-speed).epsilon(1e-14));
    }
    CHECK(run.events.size() == 3);
    CHECK(run.outcome.final[0].velocity.x() == Approx(speed).epsilon(1e-14));
    CHECK(run.outcome.final[0].position.x() == Approx(x + speed * (3 - last)).epsilon(1e-14));
}
