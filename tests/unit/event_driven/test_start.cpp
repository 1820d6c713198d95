/// What touches when a scene starts.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("spheres that touch and approach at the start collide at t = 0")
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 0.5, {0, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {1, 0, 0}, {-1, 0, 0});
    const Recorded run = record(scene);
    REQUIRE(run.events.size() == 1);
    CHECK(run.events[0].kind == EventKind::impact);
    CHECK(run.events[0].at == EpochTime{0, 0});
    CHECK(run.events[0].time == 0);
    CHECK(run.events[0].a == 0);
    CHECK(run.events[0].b == 1);
    CHECK(run.events[0].normal == Vec3(-1, 0, 0));
    CHECK(run.events[0].impulse == Vec3(-2, 0, 0));
    CHECK(run.outcome.final[0].velocity == Vec3(-1, 0, 0));
    CHECK(run.outcome.final[1].velocity == Vec3(1, 0, 0));
    CHECK(run.outcome.final[0].position == Vec3(-1, 0, 0));
}

TEST_CASE("spheres that touch and separate, or stand still, do not collide")
{
    for (const double v : {1.0, 0.0}) {
        Scene scene = empty_scene(1);
        add_sphere(scene, 0.5, {0, 0, 0}, {-v, 0, 0});
        add_sphere(scene, 0.5, {1, 0, 0}, {v, 0, 0});
        const Recorded run = record(scene);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK(run.events.empty());
        CHECK(run.outcome.final[1].position == Vec3(1 + v, 0, 0));
    }
}

TEST_CASE("a sphere that touches the floor and approaches it bounces at t = 0, one that leaves it does not")
{
    Scene scene = empty_scene(0.5, earth);
    add_floor(scene);
    add_sphere(scene, 1, {0, 0, 1}, {0, 0, -3});
    add_sphere(scene, 1, {5, 0, 1}, {0, 0, 3});
    const Recorded run = record(scene);
    REQUIRE(run.events.size() == 1);
    CHECK(run.events[0].a == 0);
    CHECK(run.events[0].b == 2);
    CHECK(run.events[0].time == 0);
    CHECK(run.events[0].normal == Vec3(0, 0, 1));
    CHECK(run.events[0].impulse == Vec3(0, 0, 6));
    CHECK(run.outcome.final[0].position.z() == run.outcome.final[1].position.z());
}

TEST_CASE("a sphere at rest on the floor stays, without events, and presses with its weight")
{
    for (const double gap : {0.0, 1e-10, -1e-10}) {
        Scene scene = empty_scene(3, earth, 0.5);
        add_floor(scene);
        add_sphere(scene, 0.5, {1, 2, 0.5 * (1 + gap)}, Vec3::Zero(), 2);
        const Recorded run = record(scene);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK(run.events.empty());
        CHECK(run.outcome.final[0].mode == Mode::resting);
        CHECK(run.outcome.final[0].position == scene.spheres[0].position);
        CHECK(run.outcome.final[0].velocity == Vec3::Zero());
        CHECK(run.outcome.rest_times[0] == 0.0);
        CHECK(run.outcome.plane_impulses[0] == Approx(2 * 9.81 * 3).epsilon(1e-14));
    }
}

TEST_CASE("a sphere that slides on the floor at the start keeps its speed and presses with its weight")
{
    Scene scene = empty_scene(2, earth, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5}, {3, 0, 0});
    const Recorded run = record(scene);
    CHECK(run.events.empty());
    CHECK(run.outcome.final[0].mode == Mode::sliding);
    CHECK(run.outcome.final[0].position == Vec3(6, 0, 0.5));
    CHECK(run.outcome.plane_impulses[0] == Approx(2 * 9.81).epsilon(1e-14));
}

TEST_CASE("a sphere a little above the floor falls, it does not rest there")
{
    Scene scene = empty_scene(1, earth, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5 + 1e-6});
    const Recorded run = record(scene);
    REQUIRE(run.events.size() >= 2);
    CHECK(run.events[0].kind == EventKind::impact);
    CHECK(run.events[0].time == Approx(std::sqrt(2e-6 / 9.81)).epsilon(1e-6));
    CHECK(run.events.back().kind == EventKind::rest);
}

TEST_CASE("without gravity a sphere that touches a wall at speed 0 stays, without events")
{
    Scene scene = empty_scene(1);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5}, {1, 0, 0});
    const Recorded run = record(scene);
    CHECK(run.events.empty());
    CHECK(run.outcome.final[0].position == Vec3(1, 0, 0.5));
    CHECK(run.outcome.plane_impulses[0] == 0);
}

TEST_CASE(
    "a sphere that slides along a tilted plane at the start slides, though its normal speed rounds to not quite 0")
{
    Random random(1);
    for (int i = 0; i < 50; ++i) {
        Scene scene = empty_scene(1, earth, 0.5);
        const Vec3 normal = (Vec3(0, 0, 1.2) + random.in_cube(0.5)).normalized();
        add_plane(scene, "incline", normal);
        add_sphere(scene, 0.5, 0.5 * scene.planes[0].normal, random.uniform(0.1, 3) * random.across(normal));
        const Recorded run = record(scene);
        CHECK(run.events.empty());
        CHECK(run.outcome.final[0].mode == Mode::sliding);
        CHECK(run.outcome.rest_times[0] == 0.0);
        CHECK(std::abs(plane_gap(scene.planes[0], scene.spheres[0], run.outcome.final[0].position)) <= 1e-14);
    }
}
