/// Runs with drag as the engine makes them: right ones hold, and agree with a program that shares nothing with it.
#include "support/damped_run.hpp"

#include "handmade.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Scene damped(Scene scene, double drag)
{
    scene.drag = drag;
    return scene;
}

/// Slides down and up, is hit, bounces until rest, leans on a wall and a fixed ball.
Scene slope()
{
    Scene scene = damped(empty_scene(8, earth, 0.6), 0.3);
    scene.materials[0].tangential = 0.9;
    add_floor(scene);
    add_plane(scene, "slope", {1, 0, 1}, 0);
    add_plane(scene, "wall", {-1, 0, 0}, -4);
    add_sphere(scene, 0.2, {-0.3, 0, 2.1}, {0.3, 0, 0});
    add_sphere(scene, 0.2, {1.6, 0.05, 0.2}, {0.5, 0, 0}, 2);
    add_sphere(scene, 0.3, {3.7, 0, 0.3});
    scene.spheres.back().fixed = true;
    return scene;
}

Scene few_in_a_box(std::uint64_t seed)
{
    Random random(seed);
    Scene scene = empty_scene(2, random.in_cube(2), random.uniform(0.7, 1));
    scene.drag = random.log_uniform(1e-6, 2);
    add_box(scene, 4);
    fill_box(scene, random, 4, 4, 0.3, 0.6, 3);
    return scene;
}

/// A ball is thrown at a plane, or at a ball that flies, too.
Scene thrown(Random& random)
{
    Scene scene = empty_scene(random.uniform(1, 4), random.in_cube(3), random.uniform(0.2, 1));
    scene.drag = random.log_uniform(1e-9, 10);
    const Vec3 from = random.in_cube(3), towards = random.direction();
    add_sphere(scene, random.uniform(0.1, 0.5), from, random.uniform(1, 6) * towards + random.in_cube(0.5));
    if (random.coin())
        add_plane(scene, "plane", -towards, -towards.dot(from) - random.uniform(0.6, 3));
    else
        add_sphere(scene, random.uniform(0.1, 0.5), from + random.uniform(1.1, 2) * towards, random.in_cube(0.5));
    return scene;
}

/// The gap at the first impact, from the flights that it ends [length].
Float<50> gap_at_first_impact(const MemorySource& run)
{
    using Real = Float<50>;
    const Event& event = run.events.front();
    const Real k(run.description.frame.drag);
    const auto time = [&](const EpochTime& t) {
        return Real(t.epoch) * Real(run.description.frame.epoch_length) + Real(t.offset);
    };
    const auto place = [&](BodyId body) {
        const FlightRecord& f = run.flights[static_cast<std::size_t>(body)];
        const DampedTime<Real> effect(k, time(event.at) - time(f.start));
        Real3<Real> x;
        for (std::size_t i = 0; i < 3; ++i)
            x[i] = effect.place(Real(f.cell[i]) * Real(run.description.frame.cell_size) + Real(f.local[i]),
                                Real(f.velocity[i]), Real(run.description.gravity[static_cast<Eigen::Index>(i)]));
        return x;
    };
    Real3<Real> x = place(event.a);
    if (run.description.spheres.size() == 1) {
        const Plane& plane = run.description.planes.front();
        return dot(lift<Real>(plane.normal), x) - Real(plane.offset) - Real(run.description.spheres[0].radius);
    }
    const Real3<Real> y = place(event.b);
    for (std::size_t i = 0; i < 3; ++i) x[i] -= y[i];
    return sqrt(dot(x, x)) - Real(run.description.spheres[0].radius) - Real(run.description.spheres[1].radius);
}

}  // namespace

TEST_CASE("100,000 throws with drag hold, and hit within the promise by 50 digits", "[verify][drag]")
{
    Random random(11);
    int hits = 0;
    double worst = 0;
    for (int n = 0; n < 100000; ++n) {
        const MemorySource run = recorded(thrown(random));
        const Certificate certificate = examined(run);
        if (!certificate.holds()) FAIL(n << ": " << first_violation(certificate));
        if (run.events.empty()) continue;
        ++hits;
        double size = 0;
        for (const FlightRecord& f : run.flights) {
            if (f.start != EpochTime{}) break;
            const double t = run.events.front().time;
            size = std::max(size, t * (Vec3(f.velocity[0], f.velocity[1], f.velocity[2]).norm() +
                                       t * run.description.gravity.norm()));
        }
        for (const RecordedSphere& sphere : run.description.spheres) size += sphere.radius;
        worst = std::max(worst, std::abs(gap_at_first_impact(run).convert_to<double>()) / size);
    }
    INFO(hits << " hits, the gap at one at most " << worst << " of the radii and the way");
    CHECK(hits > 60000);
    CHECK(worst < 16 * 0x1p-52);
}

TEST_CASE("runs of the engine with drag hold: gases, gravity, losses, slopes, heaps", "[verify][drag]")
{
    std::vector<Scene> scenes{slope(), damped(shaft(2, 9, 2), 0.5), damped(every_mode(), 0.2)};
    for (const double restitution : {1.0, 0.8})
        for (const Vec3& gravity : {Vec3(Vec3::Zero()), Vec3(0, 0, -1)})
            for (const double drag : {1e-9, 0.1, 3.0})
                scenes.push_back(damped(gas(5, 45, 2, gravity, restitution, 0.1, 0.5), drag));
    for (const Scene& scene : scenes) {
        const MemorySource run = recorded(scene);
        CHECK(run.description.frame.drag == scene.drag);
        const Certificate certificate = examined(run);
        INFO("drag " << scene.drag << ", " << scene.spheres.size() << " spheres: " << first_violation(certificate));
        CHECK(certificate.holds());
        CHECK(certificate.complete);
        CHECK(certificate.body_seconds.not_certified == 0);
        CHECK(certificate.impulses > 0);
    }
}

TEST_CASE("impacts of the engine with drag are those of a program in 50 digits", "[verify][drag]")
{
    int compared = 0;
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Scene scene = few_in_a_box(seed);
        const MemorySource run = recorded(scene);
        REQUIRE(run.events.size() > 3);
        // Later ones have the roundings of those before, multiplied at each impact of spheres.
        constexpr std::size_t first = 4;
        scene.end_time = run.events[std::min(first, run.events.size()) - 1].time + 1e-9;
        const MemorySource known = damped_run(scene);
        for (std::size_t i = 0; i < std::min(first, run.events.size()); ++i) {
            CAPTURE(seed, i);
            REQUIRE(i < known.events.size());
            CHECK(run.events[i].a == known.events[i].a);
            CHECK(run.events[i].b == known.events[i].b);
            worst = std::max(worst, std::abs(run.events[i].time - known.events[i].time));
            ++compared;
        }
    }
    INFO("largest difference " << worst << " of " << compared << " times");
    CHECK(worst < 1e-12);
}

TEST_CASE("runs of the engine with drag are refused when a number of theirs is changed", "[verify][drag]")
{
    Scene scene = gas(9, 60, 2, {0, 0, -1});
    scene.drag = 0.3;
    const MemorySource run = recorded(scene);
    REQUIRE(examined(run).holds());
    Random random(6);
    for (int n = 0; n < 60; ++n) {
        const auto i = static_cast<std::size_t>(random.integer(0, static_cast<int>(run.flights.size()) - 1));
        const auto k = static_cast<std::size_t>(n % 3);
        CAPTURE(i, k);
        MemorySource forged = run;
        forged.flights[i].local[k] += 1e-12;
        CHECK_FALSE(examined(forged).holds());
        forged = run;
        forged.flights[i].velocity[k] += 1e-12;
        CHECK_FALSE(examined(forged).holds());
        forged = run;
        forged.events.erase(forged.events.begin() + n);
        for (std::size_t& after : forged.after) after -= after > static_cast<std::size_t>(n);
        forged.seal();
        CHECK_FALSE(examined(forged).holds());
    }
    for (const double change : {1e-9, -1e-9}) {
        MemorySource forged = run;
        forged.description.frame.drag *= 1 + change;
        CHECK_FALSE(examined(forged).holds());
    }
}
