#include "motion/run_tolerances.hpp"

#include <catch2/catch.hpp>

namespace carom {

namespace {

Scene two_under_gravity(double length, double time)
{
    Scene scene;
    scene.gravity = Vec3(0, 0, -9.81) * (length / time / time);
    for (const double radius : {0.3, 0.07}) {
        Sphere s;
        s.id = radius > 0.1 ? "large" : "small";
        s.radius = radius * length;
        scene.spheres.push_back(s);
    }
    scene.materials.resize(1);
    return scene;
}

Tolerances tolerances_of(const Scene& scene)
{
    return make_tolerances(scene, rest_thresholds(scene));
}

}  // namespace

TEST_CASE("Tolerances of a run follow its units, to the last bit", "[motion]")
{
    const double length = 0x1p20, time = 0x1p-7;
    const Tolerances metres = tolerances_of(two_under_gravity(1, 1)),
                     other = tolerances_of(two_under_gravity(length, time));
    CHECK(metres.gap > 0);
    CHECK(metres.speed > 0);
    CHECK(metres.acceleration > 0);
    CHECK(other.gap == metres.gap * length);
    CHECK(other.speed == metres.speed * (length / time));
    CHECK(other.acceleration == metres.acceleration * (length / time / time));
    CHECK(other.impulse == metres.impulse);
    CHECK(other.tie == metres.tie);
}

TEST_CASE("What a scene says of its thresholds holds for the tolerances of the run", "[motion]")
{
    Scene scene = two_under_gravity(1, 1);
    scene.impact.tie = 1e-7;
    scene.rest.gap_tolerance = 1e-5;
    const Tolerances t = tolerances_of(scene);
    CHECK(t.tie == 1e-7);
    CHECK(t.gap == 1e-5);
    CHECK(t.closed(0.07) == 1e-5);
    CHECK(t.closed(1e6) > 1e-5);  // what a scene may declare closed is so
}

TEST_CASE("A body that is fast makes more speeds as good as none, a slow one does not", "[motion]")
{
    const Tolerances t = tolerances_of(two_under_gravity(1, 1));
    CHECK(t.slow(0) == t.speed);
    CHECK(t.slow(1) == t.speed);
    CHECK(t.slow(2e9) == 2 * t.slow(1e9));
    CHECK(t.slow(1e9) > t.speed);
}

}  // namespace carom
