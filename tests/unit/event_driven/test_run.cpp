/// Limits, observers, plates, and the order of events.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>
#include <map>

using namespace carom;
using namespace carom::test;

TEST_CASE("equal spheres that meet head-on swap their velocities exactly")
{
    Scene scene = empty_scene(3);
    add_sphere(scene, 0.5, {0, 0, 0}, {1.7, 0, 0});
    add_sphere(scene, 0.5, {3, 0, 0}, {-0.3, 0, 0});
    const Recorded run = record(scene);
    REQUIRE(run.events.size() == 1);
    CHECK(run.events[0].time == 1);
    CHECK(run.outcome.final[0].velocity.x() == Approx(-0.3).epsilon(1e-15));
    CHECK(run.outcome.final[1].velocity.x() == Approx(1.7).epsilon(1e-15));
}

TEST_CASE("a run stops at the event limit, in time order, and says so")
{
    const Scene scene = gas(1, 40, 5);
    RunOptions options;
    options.max_events = 50;
    const Recorded run = record(scene, EventDriven{}, options);
    CHECK(run.outcome.status == Status::event_limit);
    CHECK(run.events.size() == 50);
    CHECK(run.outcome.counts.impacts == 50);
    CHECK(run.outcome.time == run.events.back().time);
    CHECK_FALSE(run.outcome.message.empty());
    for (std::size_t i = 1; i < run.events.size(); ++i) CHECK_FALSE(run.events[i].at < run.events[i - 1].at);
}

TEST_CASE("a run stops at the time limit and says so")
{
    Scene scene = gas(1, 40, 1e9);
    RunOptions options;
    options.max_seconds = 0.05;
    const Recorded run = record(scene, EventDriven{}, options);
    CHECK(run.outcome.status == Status::time_limit);
    CHECK(run.outcome.time > 0);
    CHECK(run.outcome.time < 1e9);
}

TEST_CASE("a run whose cells are crossed but where nothing collides stops at the time limit, too")
{
    Scene scene = empty_scene(1e15);
    add_sphere(scene, 0.5, {0, 0, 0}, {1, 0.1, 0});
    add_sphere(scene, 0.5, {0, 5, 0}, {-1, 0.3, 0});
    RunOptions options;
    options.max_seconds = 0.2;
    const Recorded run = record(scene, EventDriven{BroadPhase::cell_grid}, options);
    CHECK(run.outcome.status == Status::time_limit);
    CHECK(run.outcome.time > 0);
}

TEST_CASE("an observer that says stop interrupts the run")
{
    Observer observer;
    double last = -1;
    observer.on_progress = [&](double t) {
        CHECK(t >= last);
        last = t;
        return t < 1;
    };
    const Outcome outcome = simulate(gas(1, 60, 100), EventDriven{}, {}, observer);
    CHECK(outcome.status == Status::interrupted);
    CHECK(outcome.time >= 1);
    CHECK(outcome.time < 50);
}

TEST_CASE("looking at a run changes no bit of it, and samples at the end are the final states")
{
    for (const double e : {1.0, 0.8}) {
        Scene scene = gas(2, 20, 1.5, earth, e);
        scene.rest.series_below = 0.1;
        const Outcome plain = simulate(scene, EventDriven{});
        Observer observer;
        observer.sample_times = sample_grid(1.5, 1234);
        std::vector<BodyState> last;
        std::size_t samples = 0, events = 0;
        observer.on_sample = [&](std::size_t k, double t, std::span<const BodyState> s) {
            CHECK(k == samples++);
            CHECK(t == observer.sample_times[k]);
            last.assign(s.begin(), s.end());
        };
        observer.on_event = [&](const Event&) { ++events; };
        observer.on_progress = [](double) { return true; };
        const Outcome seen = simulate(scene, EventDriven{}, {}, observer);
        INFO(plain.message);
        CHECK(seen.event_hash == plain.event_hash);
        CHECK(seen.status == plain.status);
        for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
            CHECK(seen.final[i].position == plain.final[i].position);
            CHECK(seen.final[i].velocity == plain.final[i].velocity);
        }
        CHECK(events > 0);
        if (plain.status != Status::reached_end) continue;
        REQUIRE(samples == 1235);
        for (std::size_t i = 0; i < last.size(); ++i) {
            CHECK(last[i].position == plain.final[i].position);
            CHECK(last[i].velocity == plain.final[i].velocity);
            CHECK(last[i].mode == plain.final[i].mode);
        }
    }
}

TEST_CASE("a run to t is the beginning of a run beyond t")
{
    const Scene scene = gas(3, 40, 4, earth);
    RunOptions half;
    half.until = 2;
    const Recorded whole = record(scene), part = record(scene, EventDriven{}, half);
    REQUIRE(part.events.size() < whole.events.size());
    for (std::size_t i = 0; i < part.events.size(); ++i) {
        CHECK(part.events[i].at == whole.events[i].at);
        CHECK(part.events[i].impulse == whole.events[i].impulse);
    }
    CHECK(whole.events[part.events.size()].time > 2);
    CHECK(part.outcome.time == 2);
}

TEST_CASE("gravity that is no normal number is refused before the run, and the weakest one is not")
{
    for (const double g : {5e-324, 2e-308, 0x1p-1001, 0x1p-1000}) {
        Scene scene = empty_scene(1, {0, 0, -g});
        add_floor(scene);
        add_sphere(scene, 1, {0, 0, 1});
        const Outcome out = record(scene).outcome;
        CAPTURE(g, out.message);
        CHECK((out.status == Status::unresolved) == (g < 0x1p-1000));
        for (const BodyState& end : out.final) CHECK(end.position.allFinite());
    }
}

TEST_CASE("a plate is hit from both sides and never passed, however thin and fast")
{
    for (const double thickness : {0.0, 1e-6, 0.2}) {
        Scene scene = empty_scene(10);
        add_plane(scene, "plate", Vec3::UnitX(), 1);
        scene.planes[0].thickness = thickness;
        add_plane(scene, "left", Vec3::UnitX(), -5);
        add_plane(scene, "right", -Vec3::UnitX(), -5);
        add_sphere(scene, 0.01, {-3, 0, 0}, {1000, 0, 0});
        add_sphere(scene, 0.01, {3, 1, 0}, {-777, 0, 0});
        std::int64_t hits[2] = {0, 0};
        Observer observer;
        observer.sample_times = sample_grid(10, 5000);
        observer.on_event = [&](const Event& e) {
            if (e.b != 2) return;
            ++hits[e.a];
            CHECK(e.normal == (e.a == 0 ? Vec3(-1, 0, 0) : Vec3(1, 0, 0)));
            CHECK(e.impulse.dot(e.normal) > 0);
        };
        observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) {
            CHECK(s[0].position.x() <= 1 - thickness / 2 - 0.01 + 1e-12);
            CHECK(s[1].position.x() >= 1 + thickness / 2 + 0.01 - 1e-12);
        };
        const Outcome outcome = simulate(scene, EventDriven{}, {}, observer);
        CHECK(outcome.status == Status::reached_end);
        CHECK(hits[0] == Approx(10 * 1000 / (2 * (6 - 0.02 - thickness / 2))).margin(1));
        CHECK(hits[1] == Approx(10 * 777 / (2 * (4 - 0.02 - thickness / 2))).margin(1));
        CHECK(outcome.max_penetration <= 1e-13);
    }
}

TEST_CASE("a sphere rests on a level plate, and hangs on none")
{
    Scene scene = empty_scene(4, earth, 0.5);
    add_plane(scene, "shelf", -Vec3::UnitZ(), -1);
    scene.planes[0].thickness = 0.5;
    add_sphere(scene, 0.25, {0, 0, 2});
    add_sphere(scene, 0.25, {3, 0, 0.5}, {0, 0, 0});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    CHECK(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.final[0].mode == Mode::resting);
    CHECK(run.outcome.final[0].position.z() == Approx(1.5).epsilon(1e-15));
    CHECK(run.outcome.final[1].position.z() == Approx(0.5 - 0.5 * 9.81 * 16).epsilon(1e-14));
}

TEST_CASE("one pair never has two impacts at one exact time, and none without approaching")
{
    for (const double e : {1.0, 0.9, 0.0})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const Scene scene = gas(seed, 50, 3, seed == 3 ? earth : Vec3::Zero(), e);
            std::map<std::pair<BodyId, BodyId>, EpochTime> last;
            for (const Event& event : record(scene).events) {
                if (event.kind != EventKind::impact) continue;
                const std::pair pair{event.a, event.b};
                const auto found = last.find(pair);
                CHECK((found == last.end() || found->second < event.at));
                last[pair] = event.at;
                CHECK(event.impulse.dot(event.normal) > 0);
                CHECK(event.a < event.b);
                CHECK(event.normal.norm() == Approx(1).epsilon(1e-15));
            }
            CHECK(last.size() >= (e > 0.5 ? 15 : 5));
        }
}

TEST_CASE("after an impact that takes all normal speed a pair does not meet again")
{
    // Rounding leaves about half of them approaching by an ulp: that must not be an impact of its own.
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        Scene scene = empty_scene(10, Vec3::Zero(), 0);
        const Vec3 way = random.direction(), across = random.across(way);
        const double ratio = random.log_uniform(1e-6, 1e6);
        add_sphere(scene, 0.5, random.in_cube(3), random.in_cube(1));
        add_sphere(scene, 0.3, scene.spheres[0].position + 2 * way + random.uniform(0, 0.7) * across,
                   scene.spheres[0].velocity - way, ratio);
        const Recorded run = record(scene);
        INFO(i << ", mass ratio " << ratio << ": " << run.outcome.message);
        CHECK(run.outcome.status == Status::reached_end);
        CHECK(run.events.size() == 1);
    }
}

TEST_CASE("a scene of one sphere, and one without spheres, run to their end")
{
    Scene scene = empty_scene(2, earth);
    CHECK(record(scene).outcome.status == Status::reached_end);
    CHECK(record(scene).outcome.time == 2);
    add_sphere(scene, 1, {0, 0, 0}, {1, 0, 0});
    const Outcome outcome = record(scene).outcome;
    CHECK(outcome.status == Status::reached_end);
    CHECK(outcome.final[0].position.x() == 2);
    CHECK(outcome.final[0].position.z() == Approx(-2 * 9.81).epsilon(1e-15));
}
