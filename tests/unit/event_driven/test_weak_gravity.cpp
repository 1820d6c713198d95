#include "support/scenes.hpp"

#include <carom/simulate.hpp>

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

// By powers of four of gravity, times follow by powers of two: all that changes is exponents.
TEST_CASE("a bounce to rest on a slope is the same run under gravity whose square underflows", "[weak_gravity]")
{
    const auto run = [](double gravity, double time) {
        Scene scene = empty_scene(5 * time, {0, 0, -gravity}, 0.5);
        add_plane(scene, "slope", Vec3(0.6, 0, 0.8));
        add_sphere(scene, 0.125, Vec3(0, 0, 1));
        return record(scene);
    };
    const Recorded here = run(1, 1), there = run(0x1p-996, 0x1p498);
    REQUIRE(here.outcome.counts.rests == 1);
    CHECK(there.events.size() == here.events.size());
    CHECK(there.outcome.final[0].position == here.outcome.final[0].position);
    CHECK(there.outcome.final[0].velocity * 0x1p498 == here.outcome.final[0].velocity);
    CHECK(here.outcome.final[0].velocity.norm() > 1);  // it slides
}
