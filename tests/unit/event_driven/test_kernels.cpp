/// \file
/// Kernels leave things out, never change anything: the same events, bit for bit.
#include "core/random.hpp"

#include <carom/error.hpp>
#include <carom/features.hpp>
#include <carom/simulate.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;

namespace {

/// A box with a few to many spheres of several sizes and masses, with or without gravity, fixed spheres, tilted planes,
/// plates.
Scene generated(std::uint64_t seed)
{
    Random random(seed);
    Scene scene;
    scene.end_time = 1;
    scene.materials[0].restitution = random.uniform() < 0.5 ? 1 : 0.9;
    scene.materials[0].tangential = random.uniform() < 0.8 ? 1 : 0.9;
    if (random.uniform() < 0.5) scene.gravity = {0, 0.5 * random.uniform(), -3};
    for (int k = 0; k < 3; ++k) {
        Vec3 n = Vec3::Zero();
        n[k] = 1;
        scene.planes.push_back({"low", n, -1, {}, 0});
        scene.planes.push_back({"high", -n, -1, {}, 0});
    }
    if (random.uniform() < 0.3) scene.planes.push_back({"tilted", Vec3(3, 0, 4) / 5, -0.9, {}, 0});
    const std::size_t wanted = random.uniform() < 0.3 ? 1 : 2 + static_cast<std::size_t>(60 * random.uniform());
    for (int tries = 0; scene.spheres.size() < wanted && tries < 2000; ++tries) {
        Sphere s;
        s.id = "s" + std::to_string(scene.spheres.size());
        s.radius = random.uniform(0.03, 0.1);
        s.mass = random.uniform(0.5, 4);
        for (int k = 0; k < 3; ++k) s.position[k] = random.uniform(-0.85, 0.85);
        for (int k = 0; k < 3; ++k) s.velocity[k] = random.uniform(-1, 1);
        s.fixed = wanted > 1 && random.uniform() < 0.1;
        if (s.fixed) s.velocity = Vec3::Zero();
        bool free = true;
        for (const Sphere& other : scene.spheres) {
            const double reach = s.radius + other.radius;
            free = free && (s.position - other.position).squaredNorm() > reach * reach * 1.01;
        }
        for (const Plane& p : scene.planes) free = free && plane_gap(p, s, s.position) > 0.01;
        if (free) scene.spheres.push_back(s);
    }
    return scene;
}

std::uint64_t hash_with(const Scene& scene, std::string_view kernel, BroadPhase broad_phase = BroadPhase::automatic)
{
    EventDriven method{.broad_phase = broad_phase};
    method.kernel = kernel;
    const Outcome run = simulate(scene, method);
    CHECK(run.kernel == kernel);
    return run.event_hash;
}

}  // namespace

TEST_CASE("special and general kernels, all pairs, cells and lists give the same events on 200 generated scenes",
          "[kernels]")
{
    int special = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const Scene scene = generated(seed);
        const Kernel& chosen = choose_kernel(scene);
        special += chosen.name != "general";
        CAPTURE(seed, std::string(chosen.name));
        const std::uint64_t hash = hash_with(scene, "general");
        CHECK(hash_with(scene, chosen.name) == hash);
        for (const BroadPhase search : {BroadPhase::all_pairs, BroadPhase::cell_grid, BroadPhase::neighbour_lists})
            CHECK(hash_with(scene, chosen.name, search) == hash);
    }
    CHECK(special > 80);  // else nothing was compared
}

TEST_CASE("the needs of a scene are those of its data", "[kernels]")
{
    Scene scene;
    scene.spheres.push_back({"a", 1, 1, Vec3::Zero(), Vec3::Zero(), 0, "", false});
    CHECK(needs(scene) == Features{.gravity = false, .pairs = false});
    CHECK(choose_kernel(scene).name == "single");
    scene.spheres.push_back({"b", 1, 1, {3, 0, 0}, Vec3::Zero(), 0, "", false});
    CHECK(choose_kernel(scene).name == "uniform");
    scene.gravity = {0, 0, -1e-300};
    CHECK(choose_kernel(scene).name == "general");
    CHECK_THROWS_AS(choose_kernel(scene, "uniform"), InputError);
    CHECK_THROWS_AS(choose_kernel(scene, "single"), InputError);
    CHECK_THROWS_AS(choose_kernel(scene, "fastest"), InputError);
    CHECK(choose_kernel(scene, "general").name == "general");
}

TEST_CASE("a sphere bounces off a fixed one as off a wall", "[fixed]")
{
    Scene scene;
    scene.end_time = 4;
    scene.spheres.push_back({"post", 0.5, 1e-3, Vec3::Zero(), Vec3::Zero(), 0, "", true});
    scene.spheres.push_back({"ball", 0.5, 1, {3, 0, 0}, {-1, 0, 0}, 0, "", false});
    const Outcome run = simulate(scene, EventDriven{});
    REQUIRE(run.status == Status::reached_end);
    CHECK(run.counts.impacts == 1);
    CHECK(run.final[0].position.isZero(0));
    CHECK(run.final[0].mode == Mode::fixed);
    CHECK(run.final[1].velocity == Vec3(1, 0, 0));
    CHECK(run.final[1].position.x() == Approx(3.0).epsilon(1e-15));
}

TEST_CASE("a ball dropped onto the top of a fixed sphere bounces in closed form", "[fixed]")
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.end_time = 2;
    scene.spheres.push_back({"post", 0.5, 1, Vec3::Zero(), Vec3::Zero(), 0, "", true});
    scene.spheres.push_back({"ball", 0.5, 1, {0, 0, 2}, Vec3::Zero(), 0, "", false});
    std::vector<double> times;
    Observer observer;
    observer.on_event = [&](const Event& e) { times.push_back(e.time); };
    const Outcome run = simulate(scene, EventDriven{}, {}, observer);
    REQUIRE(run.status == Status::reached_end);
    const double fall = std::sqrt(2 / 9.81);
    REQUIRE(times.size() >= 2);
    CHECK(times[0] == Approx(fall).epsilon(1e-14));
    CHECK(times[1] == Approx(3 * fall).epsilon(1e-12));
}
