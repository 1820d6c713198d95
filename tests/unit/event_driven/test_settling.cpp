/// Series, rest, and what wakes a resting sphere up.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Scene drop(double height, double restitution, double end_time)
{
    Scene scene = empty_scene(end_time, earth, restitution);
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.1 + height});
    return scene;
}

void require_same_end(const Scene& scene, double tolerance)
{
    Scene one_by_one = scene;
    one_by_one.rest.series_below = 1e-12;
    const Recorded summed = record(scene), single = record(one_by_one);
    INFO(summed.outcome.message << " / " << single.outcome.message);
    CHECK(summed.outcome.status == Status::reached_end);
    CHECK(single.outcome.status == Status::reached_end);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        CHECK((summed.outcome.final[i].position - single.outcome.final[i].position).norm() <= tolerance);
        CHECK((summed.outcome.final[i].velocity - single.outcome.final[i].velocity).norm() <= tolerance);
    }
    CHECK(summed.events.size() <= single.events.size());
    for (std::size_t p = 0; p < scene.planes.size(); ++p)
        CHECK(summed.outcome.plane_impulses[p] == Approx(single.outcome.plane_impulses[p]).epsilon(1e-9));
}

}  // namespace

TEST_CASE("when a sphere comes to rest does not depend on how many bounces are summed")
{
    const double exact = std::sqrt(2 / 9.81) * 1.8 / 0.2;
    for (const double below : {1e-12, 1e-6, 1e-3, 0.1, 10.0}) {
        Scene scene = drop(1, 0.8, 6);
        scene.rest.series_below = below;
        const Recorded run = record(scene);
        INFO("series_below " << below);
        REQUIRE(run.outcome.rest_times[0].has_value());
        CHECK(*run.outcome.rest_times[0] == Approx(exact).epsilon(1e-7));
        if (below > 1e-9) CHECK(*run.outcome.rest_times[0] == Approx(exact).epsilon(1e-13));
        CHECK(run.outcome.final[0].mode == Mode::resting);
        CHECK(run.outcome.final[0].position.z() == Approx(0.1).epsilon(1e-15));
        CHECK(run.outcome.plane_impulses[0] == Approx(9.81 * 6).epsilon(1e-12));
    }
}

TEST_CASE("inside a series every sample is the state of the bounce it is in")
{
    Scene scene = drop(0.05, 0.7, 1);
    scene.rest.series_below = 10;
    Scene one_by_one = scene;
    one_by_one.rest.series_below = 1e-12;
    Observer observer;
    observer.sample_times = sample_grid(1, 997);
    std::vector<BodyState> summed, single;
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) { summed.push_back(s[0]); };
    simulate(scene, EventDriven{}, {}, observer);
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) { single.push_back(s[0]); };
    simulate(one_by_one, EventDriven{}, {}, observer);
    REQUIRE(summed.size() == 998);
    REQUIRE(single.size() == 998);
    int in_series = 0;
    for (std::size_t k = 0; k < summed.size(); ++k) {
        in_series += summed[k].mode == Mode::series;
        CHECK(std::abs(summed[k].position.z() - single[k].position.z()) <= 1e-9);
        CHECK(summed[k].position.z() >= 0.1 - 1e-15);
    }
    CHECK(in_series > 300);
}

TEST_CASE("a series that a rolling sphere enters is revoked and ends as if its bounces had been followed")
{
    Scene scene = empty_scene(2, earth, 0.8);
    scene.rest.series_below = 1;
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.13});
    add_sphere(scene, 0.2, {-0.7, 0.05, 0.2}, {1, 0, 0}, 4);
    for (int order = 0; order < 2; ++order) {
        const Recorded run = record(scene);
        INFO(order << ": " << run.outcome.message);
        bool met = false;
        for (const Event& e : run.events) met = met || (e.a == 0 && e.b == 1);
        CHECK(met);
        require_same_end(scene, 1e-9);
        std::swap(scene.spheres[0], scene.spheres[1]);
    }
}

TEST_CASE("a series that a flying sphere enters from above or from the side is revoked")
{
    for (const Vec3& from : {Vec3(0.05, 0, 0.6), Vec3(-1, 0.03, 0.55), Vec3(0, 0, 0.45)}) {
        Scene scene = empty_scene(0.6, earth, 0.8);
        scene.rest.series_below = 1;
        add_floor(scene);
        add_sphere(scene, 0.1, {0, 0, 0.13});
        add_sphere(scene, 0.1, from, from.x() < -0.5 ? Vec3(3.3, 0, 0.3) : Vec3::Zero());
        const Recorded run = record(scene);
        bool met = false;
        for (const Event& e : run.events) met = met || (e.a == 0 && e.b == 1);
        CHECK(met);
        INFO("from " << from.transpose());
        require_same_end(scene, 1e-8);
    }
}

TEST_CASE("no series begins under a sphere that its first bounce would hit, though that moves away")
{
    // Just thrown down, the lower one comes back at 0.04; the upper one, a micrometre above it, rises slowly.
    Scene scene = empty_scene(2e-4, earth, 0.8);
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.1 + 1e-6}, {0, 0, -0.05});
    add_sphere(scene, 0.1, {0, 0, 0.3 + 2e-6}, {0, 0, 1e-3});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.events.size() >= 2);
    CHECK(run.events[0].b == 2);
    CHECK((run.events[1].a == 0 && run.events[1].b == 1));
    CHECK(run.outcome.max_penetration < 1e-15);
    // They part at 0.051 for 2e-5, and close at 0.0392 then.
    CHECK(run.events[1].time - run.events[0].time == Approx((1e-6 + 0.051 * 2e-5) / 0.0392).epsilon(0.01));
}

TEST_CASE("elastic bounces are events however low they are")
{
    const double height = 5e-5, fall = std::sqrt(2 * height / 9.81);
    const Outcome outcome = record(drop(height, 1, 0.1)).outcome;
    CHECK(outcome.counts.impacts == static_cast<std::int64_t>((0.1 / fall + 1) / 2));
    CHECK(outcome.counts.rests == 0);
    CHECK(outcome.final[0].mode == Mode::flying);
}

TEST_CASE("a sphere whose normal speed a ceiling takes falls off it after that one impact")
{
    // Rounding leaves about half of them moving into the ceiling by an ulp: that must not be an impact of its own.
    Random random(9);
    for (int i = 0; i < 100; ++i) {
        const Vec3 normal = random.direction();
        Scene scene = empty_scene(1, 2 * normal, 0);
        add_plane(scene, "ceiling", normal);
        add_sphere(scene, 0.1, 0.2 * normal, -5 * normal + 3 * random.across(normal));
        const Recorded run = record(scene);
        INFO(i << ": " << run.outcome.message);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK(run.events.size() == 1);
    }
}

TEST_CASE("a series that a wall ends is revoked")
{
    Scene scene = empty_scene(3, earth, 0.8);
    scene.rest.series_below = 1;
    add_floor(scene);
    add_plane(scene, "wall", -Vec3::UnitX(), -0.5);
    add_sphere(scene, 0.1, {0, 0, 0.13}, {1, 0, 0});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    CHECK(run.outcome.status == Status::reached_end);
    require_same_end(scene, 1e-9);
}

TEST_CASE("a resting sphere that a flying sphere hits exactly from the side slides off on its plane")
{
    Scene scene = empty_scene(0.25, earth);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    // Thrown so that at t = 0.125 it is at its apex, level with the centre of the other, and they touch.
    const double t = 0.125, up = 9.81 * t;
    add_sphere(scene, 0.25, {-0.75 - 2 * t, 0, 0.5 - 0.5 * up * t}, {2, 0, up});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    CHECK(run.outcome.status == Status::reached_end);
    REQUIRE(run.events.size() == 1);
    CHECK(run.events[0].time == Approx(t).epsilon(1e-14));
    CHECK(run.outcome.final[0].mode == Mode::sliding);
    CHECK(run.outcome.final[0].position.z() == 0.5);
    CHECK((run.outcome.final[0].velocity - Vec3(2, 0, 0)).norm() <= 1e-13);
    CHECK(run.outcome.plane_impulses[0] == Approx(9.81 * 0.25).epsilon(1e-12));
}

TEST_CASE("under a low ceiling bounces are summed only where the ceiling is out of reach")
{
    for (const double clearance : {1e-4, 3e-3, 1e-2}) {
        Scene scene = empty_scene(1, earth, 0.7);
        scene.rest.series_below = 0.1;
        add_floor(scene);
        add_plane(scene, "ceiling", -Vec3::UnitZ(), -(0.2 + clearance));
        add_sphere(scene, 0.1, {0, 0, 0.1 + 0.5 * clearance}, {0.5, 0, 1});
        const Recorded run = record(scene);
        INFO("clearance " << clearance << " " << run.outcome.message);
        CHECK(run.outcome.final[0].position.z() == Approx(0.1).epsilon(1e-14));
        require_same_end(scene, 1e-9);
    }
}

TEST_CASE("a sliding sphere that hits a resting one on the floor hands over its velocity, both keep to the floor")
{
    Scene scene = empty_scene(2, earth);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.5, {-3, 0.25, 0.5}, {2, 0, 0});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.events.size() == 1);
    CHECK(run.outcome.status == Status::reached_end);
    const Vec3 p = 1 * (run.outcome.final[0].velocity + run.outcome.final[1].velocity);
    CHECK((p - Vec3(2, 0, 0)).norm() <= 1e-14);
    for (const auto& state : run.outcome.final) {
        CHECK(state.position.z() == 0.5);
        CHECK(state.velocity.z() == 0);
        CHECK(state.mode == Mode::sliding);
    }
    CHECK(run.outcome.plane_impulses[0] == Approx(2 * 2 * 9.81).epsilon(1e-13));
}

TEST_CASE("a resting sphere hit from below its centre is released, flies and comes to rest again")
{
    Scene scene = empty_scene(5, earth, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.1, {-2, 0, 0.1}, {3, 0, 0}, 0.1);
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    // The small one is under the large one's equator: it is pressed into the floor, an impact of three contacts.
    CHECK(run.outcome.status == Status::reached_end);
    REQUIRE(run.events.size() > 2);
    CHECK(run.outcome.counts.clusters > 0);
    CHECK(run.events[1].at == run.events[0].at);

    // A small sphere that flies in rising, clear of the floor, is not.
    scene.spheres[1].position = {-2, 0, 0.2};
    scene.spheres[1].velocity = {6, 0, 1.4};
    const Recorded hit = record(scene);
    INFO(hit.outcome.message);
    CHECK(hit.outcome.status == Status::reached_end);
    int releases = 0, rests = 0;
    for (const Event& e : hit.events) {
        releases += e.kind == EventKind::release;
        rests += e.kind == EventKind::rest && e.a == 0;
    }
    CHECK(releases == 1);
    CHECK(rests == 1);
    CHECK(hit.outcome.counts.releases == 1);
    CHECK(*hit.outcome.rest_times[0] > hit.events[0].time);
    RunOptions soon;
    soon.until = hit.events[0].time + 1e-3;
    CHECK(!record(scene, EventDriven{}, soon).outcome.rest_times[0].has_value());
    double weight = 0;
    for (const auto& s : scene.spheres) weight += 9.81 * s.mass * 5;
    double momentum = -scene.spheres[1].mass * 1.4;
    for (std::size_t i = 0; i < 2; ++i) momentum += scene.spheres[i].mass * hit.outcome.final[i].velocity.z();
    CHECK(hit.outcome.plane_impulses[0] == Approx(weight + momentum).epsilon(1e-10));
}

TEST_CASE("e = 0 stops on the floor at the first touch and slides on")
{
    Scene scene = empty_scene(2, earth, 0);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 1.5}, {1, 0, 0});
    const Recorded run = record(scene);
    REQUIRE(run.events.size() == 2);
    CHECK(run.events[0].kind == EventKind::impact);
    CHECK(run.events[1].kind == EventKind::rest);
    CHECK(run.events[0].at == run.events[1].at);
    CHECK(run.outcome.final[0].mode == Mode::sliding);
    CHECK(run.outcome.final[0].position.x() == Approx(2).epsilon(1e-15));
    CHECK(run.outcome.plane_impulses[0] == Approx(2 * 9.81).epsilon(1e-14));
}

TEST_CASE("the events of a drop carry all the momentum the floor gave")
{
    const Recorded run = record(drop(1, 0.8, 6));
    double impulse = 0;
    for (const Event& e : run.events) impulse += e.impulse.z();
    CHECK(impulse == Approx(9.81 * *run.outcome.rest_times[0]).epsilon(1e-12));
}

TEST_CASE("a sphere that bounces right beside another comes to rest, also where its bounces cannot be summed")
{
    for (const double gap : {1e-3, 1e-6, 1e-9})
        for (const double e : {0.5, 0.8, 0.95}) {
            Scene scene = empty_scene(4, earth, e);
            add_floor(scene);
            add_sphere(scene, 0.1, {0, 0, 0.11});
            add_sphere(scene, 0.1, {0.2 + gap, 0, 0.1});
            const Recorded run = record(scene);
            INFO("gap " << gap << ", e " << e << ": " << run.outcome.message);
            CHECK(run.outcome.status == Status::reached_end);
            REQUIRE(run.outcome.rest_times[0].has_value());
            CHECK(*run.outcome.rest_times[0] == Approx(std::sqrt(0.02 / 9.81) * (1 + e) / (1 - e)).epsilon(1e-6));
        }
}
