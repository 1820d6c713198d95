/// Impacts of two spheres: what they report, and whom they must not overlook.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using carom::test::Random;

TEST_CASE("spheres that overlap when they meet report by how much")
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 0.5, {0, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0.999, 0, 0}, {-1, 0, 0});
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.counts.impacts == 1);
    CHECK(outcome.max_penetration == Approx(1e-3).epsilon(1e-9));
    scene.spheres[1].position.x() = 3;
    CHECK(simulate(scene, EventDriven{}).max_penetration < 1e-15);
}

TEST_CASE("a heavy sphere that is hit from both sides at once stays, whichever contact comes first")
{
    for (const int turned : {0, 1, 2}) {
        Scene scene = empty_scene(2);
        const double places[] = {-2, 0, 2}, speeds[] = {1, 0, -1}, masses[] = {1, 3, 1};
        for (int i = 0; i < 3; ++i) {
            const int k = (i + turned) % 3;
            add_sphere(scene, 0.5, {places[k], 0, 0}, {speeds[k], 0, 0}, masses[k]);
        }
        const Outcome outcome = simulate(scene, EventDriven{});
        CAPTURE(turned);
        CHECK(outcome.counts.clusters == 1);
        CHECK(outcome.counts.impacts == 2);
        for (int i = 0; i < 3; ++i) {
            const int k = (i + turned) % 3;
            CHECK((outcome.final[static_cast<std::size_t>(i)].velocity - Vec3(-speeds[k], 0, 0)).norm() < 1e-15);
        }
    }
}

TEST_CASE("spheres that hardly rebound do not meet again by rounding")
{
    Random random(5);
    for (int trial = 0; trial < 500; ++trial) {
        Scene scene = empty_scene(2, Vec3::Zero(), 1e-18);
        const Vec3 way = random.direction().normalized(), aside = random.in_cube(0.3);
        add_sphere(scene, 0.5, Vec3::Zero(), Vec3::Zero(), random.log_uniform(1, 1e3));
        add_sphere(scene, 0.5, 2 * way + aside, -2 * way, random.log_uniform(1, 1e3));
        const Outcome outcome = simulate(scene, EventDriven{});
        CAPTURE(trial);
        CHECK(outcome.status == Status::reached_end);
        CHECK(outcome.counts.impacts == 1);
    }
}
