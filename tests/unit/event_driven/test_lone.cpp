/// One sphere among planes: many bounces are carried out at once, and nobody must notice.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double g = 9.81, drop = 1, radius = 0.1;

Scene bouncing(double end_time, double restitution = 1)
{
    Scene scene = empty_scene(end_time, {0, 0, -g}, restitution);
    add_floor(scene);
    add_sphere(scene, radius, {0, 0, radius + drop});
    return scene;
}

/// Of the elastic ball, by the time since its last apex.
double height(double t)
{
    const double fall = std::sqrt(2 * drop / g), since = std::remainder(t, 2 * fall);
    return drop - g * since * since / 2;
}

}  // namespace

TEST_CASE("a streak of bounces ends at the limit of events")
{
    RunOptions options;
    options.max_events = 10;
    const Outcome outcome = simulate(bouncing(1e4), EventDriven{}, options);
    CHECK(outcome.status == Status::event_limit);
    CHECK(outcome.counts.impacts == 10);
    CHECK(outcome.time == Approx(19 * std::sqrt(2 * drop / g)).epsilon(1e-12));
}

TEST_CASE("a streak of bounces shows every sample where the ball is at that time")
{
    Observer observer;
    observer.sample_times = sample_grid(100, 777);
    std::size_t seen = 0;
    observer.on_sample = [&](std::size_t k, double t, std::span<const BodyState> states) {
        CHECK(k == seen++);
        CHECK(std::abs(states[0].position.z() - radius - height(t)) < 1e-11);
    };
    CHECK(simulate(bouncing(100), EventDriven{}, {}, observer).status == Status::reached_end);
    CHECK(seen == 778);
}

TEST_CASE("micro-collisions lower than rounding are rest")
{
    Scene scene = bouncing(10, 0.5);
    scene.rest.policy = RestPolicy::micro;
    scene.rest.closing_speed = 1e-9;
    RunOptions options;
    options.max_events = 1000;
    const Outcome outcome = simulate(scene, EventDriven{}, options);
    INFO(outcome.message);
    CHECK(outcome.status == Status::reached_end);
    CHECK(outcome.final[0].mode == Mode::resting);
    CHECK(outcome.counts.impacts < 60);
}

TEST_CASE("elastic bounces are never summed, however low")
{
    for (const int spheres : {1, 2}) {  // alone, and in company far away
        const double low = 1e-6;
        Scene scene = empty_scene(0.1, {0, 0, -g});
        add_floor(scene);
        for (int i = 0; i < spheres; ++i) add_sphere(scene, radius, {10.0 * i, 0, radius + low});
        const Outcome outcome = simulate(scene, EventDriven{});
        const double fall = std::sqrt(2 * low / g);
        const auto expected = static_cast<std::int64_t>((0.1 + fall) / (2 * fall));
        CAPTURE(spheres);
        CHECK(outcome.status == Status::reached_end);
        CHECK(outcome.counts.impacts == spheres * expected);
        for (const BodyState& state : outcome.final) CHECK(state.mode == Mode::flying);
    }
}

TEST_CASE("a sphere that leaves a plane with the rounding of its speed slides along it")
{
    Scene scene = empty_scene(100);
    add_floor(scene);
    add_sphere(scene, 1e-6, {0, 0, 1e-6 + 1e-14}, {1, 0, -5e-16});
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.counts.rests == 1);
    CHECK(outcome.final[0].mode == Mode::sliding);
    CHECK(outcome.final[0].velocity.z() == 0);
}

TEST_CASE("how often a lone sphere is looked at does not decide whether the guard takes it over", "[lone]")
{
    // Between an elastic floor and a ceiling that is nearly so: 111 bounces in a window are too many.
    Scene scene = empty_scene(1, Vec3::Zero(), 1);
    scene.guard.impacts = 1;
    scene.materials.push_back({});
    scene.materials[1].restitution = 0.99;
    add_sphere(scene, 0.5, {0, 0, 0.500004}, {1, 0, 1});
    add_floor(scene);
    add_plane(scene, "ceiling", {0, 0, -1}, -1.00001);
    scene.planes[1].material = 1;
    const Outcome alone = simulate(scene, EventDriven{});
    CHECK(alone.counts.guarded > 0);
    for (const int samples : {200, 100'000}) {
        Observer observer;
        for (int i = 0; i <= samples; ++i) observer.sample_times.push_back(1.0 * i / samples);
        CHECK(simulate(scene, EventDriven{}, {}, observer).event_hash == alone.event_hash);
    }
}
