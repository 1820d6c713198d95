// How bodies come to rest, and what happens to those at rest: series, collapse, jams, hits on what lies there, rest
// policies.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double g = 9.81;

}  // namespace

TEST_CASE("a sphere that comes to rest on others changes what their floor carries from then on")
{
    Scene scene = empty_scene(10, {0, 0, -10}, 0);
    add_floor(scene);
    for (const double z : {0.5, 1.5}) add_sphere(scene, 0.5, {0, 0, z});
    add_sphere(scene, 0.5, {0, 0, 127.5}, Vec3::Zero(), 10);  // lands after 5 s
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.final[2].mode == Mode::resting);
    CHECK(outcome.plane_impulses[0] == Approx(12 * 10 * 10).epsilon(1e-12));
}

TEST_CASE("elastic balls that stand on one another and slide do not meet without end at one instant")
{
    // Found by a review: the lowest two closed again and again, by rounding, with impulses of 0.
    Scene scene = empty_scene(0.3, {0, 0, -10});
    add_floor(scene);
    const Vec3 speeds[] = {{-0.12044842301622793, 0.40630921440908108, 0},
                           {-0.10552307060330612, -0.13661619767819833, 0},
                           {-0.32237363388037804, -0.47169925356940967, 0},
                           {0.091883767317886722, 0.32400748432064674, 0}};
    for (int i = 0; i < 4; ++i) add_sphere(scene, 0.5, {0, 0, 0.5 + i}, speeds[i], i == 3 ? 1e4 : 1);
    RunOptions options;
    options.max_events = 1'000'000;
    CHECK(simulate(scene, EventDriven{}, options).status == Status::reached_end);
}

TEST_CASE("spheres that roll out from between a floor and a fixed one go, though no contact can open at first")
{
    Scene scene = empty_scene(0.3, Vec3::Zero(), 0.5);
    scene.guard.on = false;
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 1.5}, {-1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 2.5});
    scene.spheres[2].fixed = true;
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.status == Status::reached_end);
    CHECK(outcome.counts.impacts == 0);
    CHECK((outcome.final[0].position - Vec3(0.3, 0, 0.5)).norm() < 1e-9);
    CHECK((outcome.final[1].position - Vec3(-0.3, 0, 1.5)).norm() < 1e-9);
}

TEST_CASE("tangential factors of a series are summed with it")
{
    // Flight k of the bounces lasts 2 v e^k / g at speed u alpha^k: in all 2 v u / g times alpha e / (1 - alpha e).
    const double e = 0.5, alpha = 0.75, u = 2, h = 1;
    Scene scene = empty_scene(3, earth, e);
    scene.materials[0].tangential = alpha;
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5 + h}, {u, 0, 0});
    const double fall = std::sqrt(2 * h / g), v = g * fall;
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    const double path = u * fall + 2 * v * u / g * (alpha * e) / (1 - alpha * e);
    CHECK(run.outcome.final[0].position.x() == Approx(path).margin(1e-9));
    CHECK(run.outcome.final[0].velocity == Vec3::Zero());
    CHECK(run.outcome.final[0].mode == Mode::resting);
}

TEST_CASE("an intruder meets the bounces that a series had summed")
{
    // The ball bounces lower than 1e-2 r when another comes along; with a threshold of 1e-4 r its bounces are real.
    const auto meet = [](double series_below) {
        Scene scene = empty_scene(2, earth, 0.5);
        scene.rest.series_below = series_below;
        add_floor(scene);
        add_sphere(scene, 0.1, {0, 0, 0.2});
        add_sphere(scene, 0.1, {0.6, 0, 0.1}, {-1, 0, 0});
        return record(scene);
    };
    const Recorded summed = meet(0.5), real = meet(1e-4);
    INFO(summed.outcome.message << real.outcome.message);
    REQUIRE(real.outcome.status == Status::reached_end);
    REQUIRE(summed.outcome.status == Status::reached_end);
    const auto meeting = [](const Recorded& run) {
        for (const Event& e : run.events)
            if (e.kind == EventKind::impact && e.a == 0 && e.b == 1) return e;
        return Event{};
    };
    REQUIRE(meeting(real).time > 0);
    CHECK(std::abs(meeting(real).normal.z()) > 1e-4);  // in the air
    CHECK(meeting(summed).time == Approx(meeting(real).time).epsilon(1e-9));
    CHECK((meeting(summed).impulse - meeting(real).impulse).norm() <= 1e-9);
    for (const std::size_t i : {0u, 1u})
        CHECK((summed.outcome.final[i].velocity - real.outcome.final[i].velocity).norm() <= 1e-9);
}

TEST_CASE("what stops in a wedge is pressed by gravity alone, not by the turning of a normal that it has ended")
{
    // Under a sphere and on the floor, where gravity leans into the gap. It rebounds slower than v_c, so it stays.
    Scene scene = empty_scene(1.5, {2, 0, -9.81}, 0.5);
    scene.rest.closing_speed = 0.5;
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.9});
    scene.spheres[0].fixed = true;
    add_sphere(scene, 0.5, {-1.2, 0, 0.5}, {0.3, 0, 0});
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.status == Status::reached_end);
    CHECK(outcome.final[1].mode == Mode::resting);
    CHECK((outcome.final[1].position - Vec3(-std::sqrt(1 - 0.16), 0, 0.5)).norm() < 1e-13);
    CHECK(outcome.counts.numeric_steps == 0);
}

TEST_CASE("a sphere at rest that is pushed by less than a millionth of v_c is pushed once")
{
    // Its floor takes what it gains downwards; the other must not close again and again for that.
    Scene scene = empty_scene(0.1, earth, 0.5);
    scene.rest.closing_speed = 1;
    add_floor(scene);
    add_sphere(scene, 0.5, {std::sqrt(0.49 - 0.04), 0, 0.5});
    add_sphere(scene, 0.2, {0, 0, 0.3}, {1.9e-6, 0, 0});
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.status == Status::reached_end);
    CHECK(outcome.counts.impacts == 1);
    // By the pair law: equal masses, e = 0.5, along a normal of 0.2 / 0.7 in height.
    const double across = std::sqrt(1 - 0.04 / 0.49), j = 0.75 * 1.9e-6 * across;
    CHECK(outcome.final[0].velocity.x() == Approx(j * across).epsilon(1e-9));
    CHECK(outcome.final[0].velocity.z() == 0);
    CHECK(outcome.final[1].position.z() == Approx(0.3 - 9.81 * 0.1 * 0.1 / 2).epsilon(1e-6));
}

TEST_CASE("inelastic collapse of three leaves them touching, at rest where their momenta say")
{
    // e = 0.05 < 7 - 4 sqrt(3): infinitely many impacts in finite time (McNamara and Young 1994).
    Scene scene = empty_scene(1, Vec3::Zero(), 0.05);
    add_sphere(scene, 0.0625, {-0.25, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.0625, {0, 0, 0});
    add_sphere(scene, 0.0625, {0.375, 0, 0}, {-1, 0, 0});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == Status::reached_end);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(run.outcome.final[i].velocity.x()) <= 1e-6);
        CHECK(run.outcome.final[i].position.x() ==
              Approx(0.125 / 3 + 0.125 * (static_cast<double>(i) - 1)).margin(1e-6));
    }
    CHECK(run.outcome.counts.guarded == 0);
}

TEST_CASE("policy micro: a ball with e = 0.5 is supported by its weight on average")
{
    Scene scene = empty_scene(20, earth, 0.5);
    scene.rest.policy = RestPolicy::micro;
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.15}, Vec3::Zero(), 2);
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.plane_impulses[0] / run.outcome.time == Approx(2 * g).epsilon(0.01));
    CHECK(run.outcome.final[0].position.z() == Approx(0.1).margin(1e-3));
    CHECK(run.outcome.counts.impacts > 100);  // a train of them, not a rest
}

TEST_CASE("policy none: a run stops with zeno where the bounces of a ball accumulate, and names it")
{
    Scene scene = empty_scene(6, earth, 0.5);
    scene.rest.policy = RestPolicy::none;
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 1.1});
    const Recorded run = record(scene);
    CHECK(run.outcome.status == Status::zeno);
    CHECK(run.outcome.time == Approx(std::sqrt(2 / g) * 3).margin(1e-9));
    CHECK_THAT(run.outcome.message, Catch::Matchers::Contains("s0"));
}
