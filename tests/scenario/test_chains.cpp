#include "support/scenes.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace carom;
using namespace carom::test;

TEST_CASE("counting pi: a ball between a wall and one 100^k times as heavy hits floor(10^k pi) times")
{
    const std::int64_t expected[] = {3, 31, 314, 3141, 31415};
    for (int k = 0; k <= 4; ++k) {
        Scene scene = empty_scene(1e4);
        add_plane(scene, "wall", Vec3::UnitX());
        add_sphere(scene, 0.1, {1, 0, 0});
        add_sphere(scene, 0.1, {3, 0, 0}, {-1, 0, 0}, std::pow(100, k));
        const Outcome outcome = record(scene).outcome;
        INFO("k " << k << " " << outcome.message);
        CHECK(outcome.status == Status::reached_end);
        CHECK(outcome.counts.impacts == expected[k]);
        CHECK(kinetic_energy(scene, outcome.final) == Approx(0.5 * std::pow(100, k)).epsilon(1e-10));
        CHECK(outcome.final[0].velocity.x() >= 0);
        CHECK(outcome.final[1].velocity.x() >= outcome.final[0].velocity.x());
    }
}

TEST_CASE("a cradle with gaps hands the velocity on from ball to ball, one impact each")
{
    Scene scene = empty_scene(20);
    for (int i = 0; i < 5; ++i) add_sphere(scene, 0.5, {1.25 * i, 0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0});
    const Recorded run = record(scene);
    REQUIRE(run.events.size() == 4);
    for (int i = 0; i < 4; ++i) {
        CHECK(run.events[static_cast<std::size_t>(i)].a == i);
        CHECK(run.events[static_cast<std::size_t>(i)].b == i + 1);
        CHECK(run.events[static_cast<std::size_t>(i)].time == 0.25 * (i + 1));
    }
    for (std::size_t i = 0; i < 4; ++i) CHECK(run.outcome.final[i].velocity == Vec3::Zero());
    CHECK(run.outcome.final[4].velocity == Vec3(1, 0, 0));
}

TEST_CASE("a chain of masses 1, 2, 1 with gaps leaves with (-1/3, -2/9 + ..) as two-body impacts say")
{
    Scene scene = empty_scene(3);
    const double masses[] = {1, 2, 1};
    for (int i = 0; i < 3; ++i) add_sphere(scene, 0.5, {1.25 * i, 0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0}, masses[i]);
    const Recorded run = record(scene);
    REQUIRE(run.events.size() == 2);
    // As the touching chain of the known answers: (-1/3, 2/9, 8/9).
    CHECK(run.outcome.final[0].velocity.x() == Approx(-1.0 / 3).epsilon(1e-14));
    CHECK(run.outcome.final[1].velocity.x() == Approx(2.0 / 9).epsilon(1e-14));
    CHECK(run.outcome.final[2].velocity.x() == Approx(8.0 / 9).epsilon(1e-14));
}

TEST_CASE("two-ball drop: with 3 below and 1 above, apart by a hair, the lower stops and the upper leaves at 2")
{
    // Both at speed 1 down; the lower bounces first, then meets the upper. No gravity, as the impacts are instant.
    Scene scene = empty_scene(2);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 1.5}, {0, 0, -1}, 3);
    add_sphere(scene, 0.25, {0, 0, 1.5 + 0.75 + 1e-3}, {0, 0, -1}, 1);
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.events.size() == 2);
    CHECK(run.events[0].b == 2);
    CHECK(run.events[1].b == 1);
    CHECK(run.outcome.final[0].velocity.norm() <= 1e-15);
    CHECK(run.outcome.final[1].velocity.z() == Approx(2).epsilon(1e-14));
}

TEST_CASE("a head-on pair of unequal masses and restitution leaves as the formula says")
{
    Scene scene = empty_scene(3, Vec3::Zero(), 0.6);
    add_sphere(scene, 0.5, {0, 0, 0}, {2, 0, 0}, 3);
    add_sphere(scene, 0.5, {3, 0, 0}, {-1, 0, 0}, 5);
    const Recorded run = record(scene);
    REQUIRE(run.events.size() == 1);
    CHECK(run.events[0].time == Approx(2.0 / 3).epsilon(1e-15));
    const double j = 1.6 * 15.0 / 8 * 3;
    CHECK(run.outcome.final[0].velocity.x() == Approx(2 - j / 3).epsilon(1e-14));
    CHECK(run.outcome.final[1].velocity.x() == Approx(-1 + j / 5).epsilon(1e-14));
    CHECK(run.events[0].impulse.x() == Approx(-j).epsilon(1e-14));
}

TEST_CASE("attenuation multiplies both velocities after the exchange, and a moving frame shows it")
{
    const auto leave = [](double frame) {
        Scene scene = empty_scene(3);
        scene.contacts = {{0, 0, {}, {}, 0.5}};
        add_sphere(scene, 0.5, {0, 0, 0}, {1 + frame, 0, 0});
        add_sphere(scene, 0.5, {2, 0, 0}, {frame, 0, 0});
        return record(scene).outcome.final[1].velocity.x() - frame;
    };
    CHECK(leave(0) == 0.5);
    CHECK(leave(10) == 0.5 * 11 - 10);
}
