/// What the engine cannot resolve yet it says: a status, names and a time; never a hang, never a wrong answer.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <array>

using namespace carom;
using namespace carom::test;

namespace {

Outcome require_unresolved(const Scene& scene, const std::vector<std::string>& words, BroadPhase broad_phase)
{
    const Outcome outcome = record(scene, EventDriven{broad_phase}).outcome;
    INFO(name(outcome.status) << " at " << outcome.time << ": " << outcome.message);
    CHECK(outcome.status == Status::unresolved);
    for (const auto& word : words) CHECK(outcome.message.find(word) != std::string::npos);
    CHECK(outcome.message.find("at t = ") != std::string::npos);
    CHECK(outcome.final.size() == scene.spheres.size());
    for (const auto& state : outcome.final) {
        CHECK(state.position.allFinite());
        CHECK(state.velocity.allFinite());
    }
    return outcome;
}

Outcome require_unresolved(const Scene& scene, const std::vector<std::string>& words)
{
    const Outcome grid = require_unresolved(scene, words, BroadPhase::cell_grid);
    const Outcome pairs = require_unresolved(scene, words, BroadPhase::all_pairs);
    CHECK(grid.message == pairs.message);
    CHECK(grid.event_hash == pairs.event_hash);
    return pairs;
}

}  // namespace

TEST_CASE("a cradle is unresolved: the hit on one of two touching spheres goes on to the other at once")
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {1, 0, 0});
    const Outcome outcome = require_unresolved(scene, {"s1", "s2"});
    CHECK(outcome.time == Approx(1));
}

TEST_CASE("two spheres that hit a third at one instant are unresolved")
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {2, 0, 0}, {-1, 0, 0});
    const Outcome outcome = require_unresolved(scene, {"s0", "s1", "s2"});
    CHECK(outcome.counts.impacts == 0);
    CHECK(outcome.time == Approx(1));
}

TEST_CASE("a sphere that hits two touching ones at once is unresolved, whatever rounding makes of the tie")
{
    Random random(4);
    for (int i = 0; i < 50; ++i) {
        const Vec3 ahead = random.direction(), across = random.across(ahead);
        Scene scene = empty_scene(3);
        add_sphere(scene, 0.5, -2 * ahead, ahead);
        for (const double side : {0.5, -0.5}) add_sphere(scene, 0.5, std::sqrt(0.75) * ahead + side * across);
        require_unresolved(scene, {"s0", "s1", "s2"});
    }
}

TEST_CASE("two separate impacts at one instant are no cluster")
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {-2, 5, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 5, 0});
    const Recorded run = record(scene);
    CHECK(run.outcome.status == Status::reached_end);
    REQUIRE(run.events.size() == 2);
    CHECK(run.events[0].at == run.events[1].at);
}

TEST_CASE("a corner hit is unresolved, an edge passed one wall after the other is not")
{
    Scene scene = empty_scene(3);
    add_plane(scene, "left", Vec3::UnitX());
    add_plane(scene, "front", Vec3::UnitY());
    add_sphere(scene, 0.5, {2, 2, 0}, {-1, -1, 0});
    const Outcome outcome = require_unresolved(scene, {"s0", "left", "front"});
    CHECK(outcome.time == Approx(1.5));

    scene.spheres[0].position.y() = 2.001;
    const Recorded run = record(scene);
    CHECK(run.outcome.status == Status::reached_end);
    CHECK(run.events.size() == 2);
    CHECK(run.outcome.final[0].velocity == Vec3(1, 1, 0));
}

TEST_CASE("a sphere at rest on a resting sphere is unresolved")
{
    Scene scene = empty_scene(3, earth, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.5, {0, 0, 1.5});
    require_unresolved(scene, {"s0", "s1"});
}

TEST_CASE("a sphere dropped onto a resting sphere is unresolved: the floor takes part")
{
    Scene scene = empty_scene(3, earth, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.5, {0.1, 0, 2.5});
    require_unresolved(scene, {"s0", "s1"});
}

TEST_CASE("a sphere in a V groove ends unresolved, whether it falls in or lies there")
{
    for (const double height : {0.0, 0.5}) {
        for (const double offset : {0.0, 0.03}) {
            Scene scene = empty_scene(20, earth, 0.5);
            add_plane(scene, "left", {1, 0, 1});
            add_plane(scene, "right", {-1, 0, 1});
            add_sphere(scene, 0.1, {height > 0 ? offset : 0, 0, 0.1 * std::sqrt(2.0) + height});
            INFO("height " << height << ", offset " << offset);
            require_unresolved(scene, {"s0"});
        }
    }
}

TEST_CASE("an inelastic sphere squeezed between two others ends unresolved, not in an endless series")
{
    Scene scene = empty_scene(10, Vec3::Zero(), 0.05);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {2.0625, 0, 0}, {-1, 0, 0});
    require_unresolved(scene, {"s1"});
}

TEST_CASE("many impacts of one sphere in a short time accumulate, and that is said long before they are a tie")
{
    // A light ball between the floor and a heavy one that comes down: thousands of bounces in a millisecond.
    Scene scene = empty_scene(1, Vec3::Zero(), 0.99);
    scene.rest.numeric_step = 1e-2;
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.1005}, Vec3::Zero(), 1e-6);
    add_sphere(scene, 0.1, {0, 0, 0.301}, {0, 0, -1}, 1e6);
    const Outcome outcome = require_unresolved(scene, {"s0", "accumulate"});
    CHECK(outcome.counts.impacts > 90);
    CHECK(outcome.counts.impacts < 300);
}

TEST_CASE("a sphere that slides to rest at a second plane is unresolved")
{
    Scene scene = empty_scene(3, earth, 0);
    add_floor(scene);
    add_plane(scene, "wall", -Vec3::UnitX(), -2);
    add_sphere(scene, 0.5, {0, 0, 0.5}, {1, 0, 0});
    const Outcome outcome = require_unresolved(scene, {"s0", "wall", "second plane"});
    CHECK(outcome.time == Approx(1.5));
}

TEST_CASE("a heap that settles ends unresolved with names")
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Outcome outcome = record(gas(seed, 30, 60, earth, 0.5)).outcome;
        INFO(outcome.message);
        CHECK(outcome.status == Status::unresolved);
        CHECK(outcome.message.find("s") != std::string::npos);
        CHECK(outcome.time > 0.1);
    }
}

TEST_CASE("numbers whose squares leave the range of doubles are said so before the run begins")
{
    const auto outcome = [](double radius, double mass, double speed, double offset, bool certified) {
        Scene scene = empty_scene(2, earth);
        add_sphere(scene, radius, {1.125, 0, 1});
        add_sphere(scene, 0.25, {2.5, 0, 1}, {-speed, 0, 0}, mass);
        add_plane(scene, "wall", Vec3::UnitX(), -offset);
        EventDriven method;
        method.certified = certified;
        RunOptions options;
        options.max_events = 100;
        return simulate(scene, method, options);
    };
    for (const bool certified : {false, true}) {
        CHECK(outcome(0.125, 1e4, 1, 1, certified).message == "");
        for (const auto& [radius, mass, speed, offset] : {std::array{0.125, 1e4, 1e300, 1.},
                                                          {5e-324, 1., 1., 1.},
                                                          {0.125, 1e-300, 1., 1.},
                                                          {0.125, 1., 1., 1e300},
                                                          {0.125, 1e100, 1e100, 1.}}) {
            const Outcome out = outcome(radius, mass, speed, offset, certified);
            CAPTURE(radius, mass, speed, offset, out.message);
            CHECK(out.status == Status::unresolved);
            CHECK(out.message.find("range of doubles") != std::string::npos);
            CHECK(out.final.size() == 2);
            CHECK(out.time == 0);
        }
    }
}

TEST_CASE("a wall so far away that its impact is never is no impact of a certified run")
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 0.5, {0, 0, 0}, {1e9, 2, 3});
    add_sphere(scene, 0.5, {2, 0, 0}, {1e9, 2, 3});
    add_plane(scene, "far", -Vec3::UnitX(), -0x1p399);
    EventDriven method;
    method.certified = true;
    const Outcome out = simulate(scene, method);
    CHECK(out.status == Status::reached_end);
    CHECK(out.counts.impacts == 0);
    CHECK(out.final[0].position.x() == Approx(1e9));
}

TEST_CASE("an end or a place that the frame cannot count to is said so; the run does not go on for ever")
{
    RunOptions options;
    Scene ball = empty_scene(1);
    add_sphere(ball, 0.1, {0, 0, 1}, {1e3, 0, 0});
    for (const bool certified : {false, true}) {
        EventDriven method;
        method.certified = certified;
        options.until = 1e12;
        CHECK(simulate(ball, method, options).status == Status::reached_end);
        for (const double until : {1e20, 1e200, 1e301}) {
            options.until = until;
            const Outcome out = simulate(ball, method, options);
            CAPTURE(until, out.message);
            CHECK(out.status == Status::unresolved);
            CHECK(out.time == 0);
        }
        options.until = 1;
        Scene dust = empty_scene(1);
        add_sphere(dust, 0.5, {-2, 0, 0}, {1, 0, 0});
        add_sphere(dust, 1e-48, {0, 0, 0});
        const Outcome out = simulate(dust, method, options);
        CHECK(out.message.find("smallest radius") != std::string::npos);
    }
}

TEST_CASE("an end so late that what falls until then leaves the range of doubles is said so")
{
    Scene scene = empty_scene(1e169, {0, 8, -9.81}, 0.8);
    add_sphere(scene, 0.1, {-1, 0, 1.1});
    add_floor(scene);
    const Outcome out = simulate(scene, EventDriven{});
    CHECK(out.status == Status::unresolved);
    CHECK(out.message.find("range of doubles") != std::string::npos);
    scene.end_time = 1e120;
    CHECK(simulate(scene, EventDriven{}).final[0].position.allFinite());
}
