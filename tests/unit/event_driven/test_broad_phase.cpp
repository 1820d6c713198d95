/// Which broad phase finds the pairs must not matter, bit for bit.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

void require_same_run(const Scene& scene, std::int64_t at_least)
{
    RunOptions options;
    options.max_seconds = 20;
    options.max_events = 20000;
    const Outcome pairs = simulate(scene, EventDriven{BroadPhase::all_pairs}, options);
    const Outcome grid = simulate(scene, EventDriven{BroadPhase::cell_grid}, options);
    INFO(name(pairs.status) << " " << pairs.message << " / " << name(grid.status) << " " << grid.message);
    CHECK(pairs.status != Status::time_limit);
    CHECK(pairs.status == grid.status);
    CHECK(pairs.message == grid.message);
    CHECK(pairs.event_hash == grid.event_hash);
    CHECK(pairs.counts.impacts == grid.counts.impacts);
    CHECK(pairs.counts.rests == grid.counts.rests);
    CHECK(pairs.time == grid.time);
    CHECK(pairs.counts.impacts >= at_least);
    const Outcome lists = simulate(scene, EventDriven{BroadPhase::neighbour_lists}, options);
    CHECK(lists.status == pairs.status);
    CHECK(lists.message == pairs.message);
    CHECK(lists.event_hash == pairs.event_hash);
    CHECK(lists.time == pairs.time);
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        CHECK(pairs.final[i].position == grid.final[i].position);
        CHECK(pairs.final[i].velocity == grid.final[i].velocity);
    }
    for (std::size_t p = 0; p < scene.planes.size(); ++p) CHECK(pairs.plane_impulses[p] == grid.plane_impulses[p]);
}

}  // namespace

TEST_CASE("lists, grid and all pairs give the same run of a gas in a box")
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) require_same_run(gas(seed, 60, 6), 200);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) require_same_run(gas(seed, 60, 6, earth), 200);
}

TEST_CASE("lists, grid and all pairs give the same run of mixed radii")
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        require_same_run(gas(seed, 150, 2, Vec3::Zero(), 1, 0.02, 1.2), 100);
        require_same_run(gas(seed, 150, 2, earth, 1, 0.02, 1.2), 100);
    }
}

TEST_CASE("lists, grid and all pairs give the same run without walls, however far the spheres fly apart")
{
    Scene scene = empty_scene(1000);
    Random random(5);
    fill_box(scene, random, 80, 8, 0.3, 0.5, 3);
    require_same_run(scene, 20);
    scene.gravity = earth;
    scene.end_time = 10;
    require_same_run(scene, 20);
}

TEST_CASE("lists, grid and all pairs give the same run of a gas that loses energy, to its unresolved end")
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
        require_same_run(gas(seed, 40, 30, earth, 0.5 + 0.05 * static_cast<double>(seed)), 30);
}

TEST_CASE("lists, grid and all pairs give the same run of few spheres that settle in series on a floor")
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Scene scene = empty_scene(20, earth, 0.6);
        add_floor(scene);
        Random random(seed);
        for (int i = 0; i < 40; ++i)
            add_sphere(scene, 0.1, Vec3(i % 7, i / 7, random.uniform(0.2, 2)),
                       Vec3(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0));
        require_same_run(scene, 100);
    }
}

TEST_CASE("lists, grid and all pairs give the same run with large and rough series")
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Scene scene = empty_scene(20, earth, 0.7);
        scene.materials[0].tangential = 0.9;
        scene.rest.series_below = seed % 2 == 0 ? 0.1 : 1;
        add_floor(scene);
        Random random(seed);
        for (int i = 0; i < 40; ++i)
            add_sphere(scene, 0.1, Vec3(0.5 * (i % 7), 0.5 * (i / 7), random.uniform(0.2, 1)),
                       Vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0));
        require_same_run(scene, 100);
    }
}

TEST_CASE("who turns round at a cell wall faster than times can tell does not cross it for ever")
{
    // Up at 1e-25 and down at once: back at the wall, which is at height 0 as every cell's is, after 5e-20.
    Scene scene = empty_scene(2, {0, 0, -4e-6});
    for (int i = 0; i < 4; ++i) add_sphere(scene, 0.25, {static_cast<double>(i), 0, 0}, {0, 0, 1e-25});
    RunOptions options;
    options.max_seconds = 5;
    const Outcome outcome = simulate(scene, EventDriven{BroadPhase::cell_grid}, options);
    CHECK(outcome.status == Status::reached_end);
    CHECK(outcome.counts.cell_crossings < 10);
}
