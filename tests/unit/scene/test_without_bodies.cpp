#include "scene/without_bodies.hpp"

#include <catch2/catch.hpp>

using namespace carom;

TEST_CASE("the world of a scene has its field, laws and thresholds, and none of its bodies", "[scene]")
{
    Scene scene;
    scene.name = "a";
    scene.units = {"m", "s", "kg"};
    scene.gravity = Vec3(1, 2, 3);
    scene.drag = 0.5;
    scene.origin = Vec3(4, 5, 6);
    scene.end_time = 7;
    scene.seed = 8;
    scene.materials.push_back({"rubber", 0.8, 1, ""});
    scene.contacts.resize(1);
    scene.rest.policy = RestPolicy::none;
    scene.impact.impact_operator = ImpactOperator::lcp;
    scene.guard.on = false;
    scene.spheres.resize(2);
    scene.planes.resize(1);
    scene.checks.resize(1);
    const Scene world = without_bodies(scene);
    CHECK(world.units.length == "m");
    CHECK(world.gravity == Vec3(1, 2, 3));
    CHECK(world.drag == 0.5);
    CHECK(world.origin == Vec3(4, 5, 6));
    CHECK(world.end_time == 7);
    CHECK(world.seed == 8);
    CHECK(world.materials.size() == 2);
    CHECK(world.contacts.size() == 1);
    CHECK(world.rest.policy == RestPolicy::none);
    CHECK(world.impact.impact_operator == ImpactOperator::lcp);
    CHECK_FALSE(world.guard.on);
    CHECK(world.name.empty());
    CHECK(world.spheres.empty());
    CHECK(world.planes.empty());
    CHECK(world.checks.empty());
}
