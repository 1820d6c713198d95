#include "support/damped_run.hpp"

#include "handmade.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Scene damped_scene(double drag, double end_time, const Vec3& gravity, double restitution = 1)
{
    Scene scene = empty_scene(end_time, gravity, restitution);
    scene.drag = drag;
    return scene;
}

/// A ball thrown over a floor, under a ceiling.
Scene thrown_ball(double drag = 0.4, double restitution = 0.8)
{
    Scene scene = damped_scene(drag, 5, {0, 0, -1}, restitution);
    add_floor(scene);
    add_plane(scene, "ceiling", -Vec3::UnitZ(), -2.2);
    add_sphere(scene, 0.5, {0.3, 0.7, 1}, {1, -0.2, 1.5});
    return scene;
}

/// Two balls of two masses meet off-centre above a floor.
Scene two_balls(double drag = 0.3)
{
    Scene scene = damped_scene(drag, 6, {0, 0, -1}, 0.9);
    add_floor(scene);
    add_sphere(scene, 0.5, {-1.3, 0.1, 1}, {1.2, 0, 1}, 2);
    add_sphere(scene, 0.3, {1.1, 0, 1.2}, {-1.5, 0.05, 0.9}, 0.7);
    return scene;
}

/// Some spheres in a box, of which one is fixed.
Scene damped_gas(std::uint64_t seed, int count = 5)
{
    Random random(seed);
    Scene scene = damped_scene(random.log_uniform(1e-3, 1), 3, random.in_cube(1), random.uniform(0.6, 1));
    add_box(scene, 4);
    fill_box(scene, random, count, 4, 0.3, 0.5, 3);
    if (random.coin()) {
        scene.spheres.back().fixed = true;
        scene.spheres.back().velocity = Vec3::Zero();
    }
    return scene;
}

/// \returns the violation, or "" \pre of the run as it was, nothing is refused
std::string refusal(MemorySource forged)
{
    forged.seal();
    return first_violation(examined(std::move(forged)));
}

}  // namespace

TEST_CASE("runs with drag that an event program in 50 digits made hold, every gap decided", "[verify][drag]")
{
    std::vector<Scene> scenes{thrown_ball(), thrown_ball(1e-9), thrown_ball(3, 1), two_balls(), two_balls(1e-12)};
    for (std::uint64_t seed = 1; seed <= 16; ++seed) scenes.push_back(damped_gas(seed));
    std::int64_t impacts = 0;
    for (const Scene& scene : scenes) {
        const MemorySource run = damped_run(scene);
        for (const bool all_pairs : {false, true}) {
            const Certificate certificate = examined(run, all_pairs);
            INFO(first_violation(certificate));
            CHECK(certificate.holds());
            CHECK(certificate.complete);
            CHECK(certificate.body_seconds.not_certified == 0);
            CHECK(certificate.largest_jump < 1);
        }
        impacts += static_cast<std::int64_t>(run.events.size());
    }
    CHECK(impacts > 150);
}

TEST_CASE("many spheres with drag are covered by cells as by all pairs", "[verify][drag]")
{
    Random random(8);
    Scene scene = damped_scene(0.5, 2, {0, 0, -0.5});
    add_box(scene, 10);
    fill_box(scene, random, 60, 10, 0.3, 0.5, 3);
    REQUIRE(scene.spheres.size() == 60);
    MemorySource run = damped_run(scene);
    CHECK_HOLDS(examined(run));
    // Impacts left out: the same pairs are seen to overlap.
    run.events.clear();
    run.flights.resize(scene.spheres.size());
    run.after.assign(scene.spheres.size(), 0);
    run.seal();
    const Certificate by_cells = examined(run), by_pairs = examined(run, true);
    CHECK_FALSE(by_cells.holds());
    CHECK_FALSE(by_pairs.holds());
    CHECK(by_cells.smallest_gap == by_pairs.smallest_gap);
}

TEST_CASE("another drag in the head is refused", "[verify][drag]")
{
    for (const Scene& scene : {thrown_ball(), two_balls()}) {
        const MemorySource run = damped_run(scene);
        REQUIRE(refusal(run).empty());
        for (const double change : {1e-9, -1e-9, 1e-3}) {
            MemorySource forged = run;
            forged.description.frame.drag *= 1 + change;
            CAPTURE(change);
            CHECK_FALSE(refusal(forged).empty());
        }
        MemorySource none = run;
        none.description.frame.drag = 0;
        CHECK_FALSE(refusal(none).empty());
        for (const double drag : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
            none.description.frame.drag = drag;
            CHECK_FALSE(examined(none).holds());
        }
    }
}

TEST_CASE("a drag that is said of a run without drag is refused, and any drag of a certified run", "[verify][drag]")
{
    for (const bool certified : {false, true}) {
        MemorySource run = recorded(gas(9, 60, 2, {0, 0, -1}), {}, certified);
        REQUIRE(refusal(run).empty());
        run.description.frame.drag = certified ? 1e-300 : 1e-9;
        CHECK_FALSE(refusal(run).empty());
    }
}

TEST_CASE("a damped flight shifted by 1e-12, or as much faster, is refused", "[verify][drag]")
{
    for (const Scene& scene : {thrown_ball(), two_balls()}) {
        const MemorySource run = damped_run(scene);
        for (std::size_t i = 0; i < run.flights.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                CAPTURE(i, k);
                MemorySource forged = run;
                forged.flights[i].local[k] += 1e-12;
                CHECK_FALSE(refusal(forged).empty());
                forged = run;
                forged.flights[i].velocity[k] += 1e-12;
                CHECK_FALSE(refusal(forged).empty());
                forged = run;
                forged.flights[i].start.offset += 1e-12;
                CHECK_FALSE(refusal(forged).empty());
            }
    }
}

TEST_CASE("what is allowed goes with the way of a damped flight, not with its time", "[verify][drag]")
{
    // It falls for 400 at a speed of 0.5, which g t is far above.
    Scene scene = damped_scene(2, 401, {0, 0, -1});
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 200.5}, {1, 0, 0});
    const MemorySource run = damped_run(scene);
    REQUIRE(run.flights.size() > 1);
    CHECK(refusal(run).empty());
    MemorySource forged = run;
    forged.flights[1].local[2] += 1e-12;
    CHECK_FALSE(refusal(forged).empty());
    forged = run;
    forged.flights[1].local[0] += 1e-14;
    CHECK_FALSE(refusal(forged).empty());
    forged = run;
    forged.flights[1].velocity[2] += 1e-14;
    CHECK_FALSE(refusal(forged).empty());
}

TEST_CASE("an impact with drag that is left out or invented is refused", "[verify][drag]")
{
    const Scene scene = two_balls();
    const MemorySource run = damped_run(scene);
    REQUIRE(run.events.size() >= 6);
    // Left out: the flights go on, through the plane or the other ball.
    for (std::size_t n = 0; n < run.events.size(); ++n) {
        MemorySource forged = run;
        forged.events.resize(n);
        while (forged.after.back() > n) {
            forged.flights.pop_back();
            forged.after.pop_back();
        }
        CAPTURE(n);
        CHECK_THAT(refusal(forged), Catch::Matchers::Contains("overlap"));
    }
    // Invented, with the flight that follows from it: in mid-air.
    MemorySource invented = damped_run(two_balls());
    const auto& first = invented.events.front();
    const double t = (static_cast<double>(first.at.epoch) + first.at.offset) / 2;
    FlightRecord f = run.flights[0];
    const DampedTime<Float<50>> effect(scene.drag, t);
    for (std::size_t k = 0; k < 3; ++k) {
        const double a = scene.gravity[static_cast<Eigen::Index>(k)];
        f.local[k] = effect.place(Float<50>(f.cell[k]) + f.local[k], f.velocity[k], a).convert_to<double>();
        f.velocity[k] = effect.speed(f.velocity[k], a).convert_to<double>();
        f.cell[k] = 0;
    }
    f.start = {0, t};
    Event push{EventKind::impact, f.start, t, 0, 2, Vec3::UnitZ(), {0, 0, 1}};
    f.velocity[2] += 0.5;
    invented.events.insert(invented.events.begin(), push);
    invented.flights.insert(invented.flights.begin() + 2, f);
    for (std::size_t& after : invented.after) after += after > 0;
    invented.after.insert(invented.after.begin() + 2, 1);
    CHECK_THAT(refusal(invented), Catch::Matchers::Contains("pushed at a gap"));
}

TEST_CASE("a flight without drag in a run with drag is refused, whatever comes after it", "[verify][drag]")
{
    // The ball falls as if there were no air, to a floor that is where such a ball meets it.
    const Scene scene = thrown_ball();
    MemorySource run = damped_run(scene);
    for (std::size_t i = 1; i < run.flights.size(); ++i) {
        MemorySource forged = run;
        const FlightRecord &from = run.flights[i - 1], &to = run.flights[i];
        const double t = static_cast<double>(to.start.epoch - from.start.epoch) + (to.start.offset - from.start.offset);
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = scene.gravity[static_cast<Eigen::Index>(k)];
            forged.flights[i].cell[k] = from.cell[k];
            forged.flights[i].local[k] = from.local[k] + t * (from.velocity[k] + t * a / 2);
        }
        CAPTURE(i);
        CHECK_THAT(refusal(forged), Catch::Matchers::Contains("jumps by"));
    }
}

TEST_CASE("drag allows no series of bounces, and rest and sliding are damped as flights are", "[verify][drag]")
{
    Scene scene = damped_scene(0.5, 2, {0, 0, -1}, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.5, {3, 0, 0.5}, {1, 0, 0});
    Handmade slides(scene);
    slides.start(Mode::resting, 0);
    slides.start(Mode::sliding, 0);
    CHECK_HOLDS(slides.examined());
    CHECK(slides.examined().body_seconds.exact == 4);
    // It comes as far as (1 - exp(-1))/0.5 in two units of time, before a ball that waits there; without drag as far
    // as 2.
    for (const auto& [gap, holds] : {std::pair{1.3, true}, std::pair{1.2, false}}) {
        Scene waiting = scene;
        add_sphere(waiting, 0.5, {4 + gap, 0, 0.5});
        Handmade run(waiting);
        run.start(Mode::resting, 0);
        run.start(Mode::sliding, 0);
        run.start(Mode::resting, 0);
        CAPTURE(gap);
        CHECK(run.examined().holds() == holds);
    }
    Handmade series(scene);
    series.start(Mode::resting, 0);
    FlightRecord& f = series.start(Mode::series, 0);
    f.series = SeriesRecord{0.1, 1, 0.5, 1, {1, 0, 0}, Vec3::Zero()};
    CHECK_REFUSED(series.examined(), "series");
}
