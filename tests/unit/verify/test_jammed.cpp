// Who touches several others: what the verifier lets pass there, and nowhere else.
#include "support/recorded.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

Scene drop()
{
    Scene scene = empty_scene(5, earth, 0.8);
    add_sphere(scene, 0.1, {0, 0, 1.1}, {0.2, 0, 0});
    add_floor(scene);
    return scene;
}

}  // namespace

TEST_CASE("bounces below the minimal speed of the policy micro are elastic, and of no other", "[verify]")
{
    Scene scene = drop();
    scene.rest.policy = RestPolicy::micro;
    MemorySource micro = recorded(scene);
    CHECK(micro.description.window == 0);
    REQUIRE(micro.events.size() > 50);
    const Certificate held = examined(micro);
    INFO(first_violation(held));
    CHECK(held.holds());
    micro.description.window = rest_thresholds(drop()).window;
    CHECK(!examined(micro).holds());
    // Nor may micro lose what the others do.
    Scene plain = drop();
    plain.rest.closing_speed = 0.5;
    MemorySource other = recorded(plain);
    CHECK(examined(other).holds());
    other.description.window = 0;
    CHECK(!examined(other).holds());
}

TEST_CASE("who touches others may be jammed; who does not rebounds", "[verify]")
{
    // The lower of two between floor and ceiling is thrown at the floor, and stays.
    Scene scene = empty_scene(1, {10, 0, 0}, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.125, {0, 0, 0.125}, {0, 0, -1});
    Scene free = scene;
    add_sphere(scene, 0.125, {0, 0, 0.375}, {1, 0, 0});
    add_plane(scene, "ceiling", -Vec3::UnitZ(), -0.5);
    const Certificate jammed = examined(recorded(scene));
    INFO(first_violation(jammed));
    CHECK(jammed.holds());
    MemorySource run = recorded(free);
    REQUIRE(run.events.size() == 1);
    REQUIRE(run.flights.back().velocity[2] == 0.5);
    CHECK(examined(run).holds());
    run.events.front().impulse /= 1.5;
    run.flights.back().velocity[2] = 0;
    run.seal();
    CHECK(!examined(run).holds());
}

TEST_CASE("a table that both lie on is in nobody's way", "[verify]")
{
    Scene scene = empty_scene(1, {0, 0, -10}, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.125, {0, 0, 0.125}, {1, 0, 0});
    add_sphere(scene, 0.125, {0.5, 0, 0.125});
    MemorySource run = recorded(scene);
    CHECK(examined(run).holds());
    run.description.materials[0].restitution = 0.8;
    CHECK(!examined(run).holds());
}

TEST_CASE("nobody hovers on contacts across gravity", "[verify]")
{
    // Between two fixed spheres, any way round; then the floor is taken away.
    carom::test::Random random(3);
    for (int n = 0; n < 50; ++n) {
        const Vec3 up = random.direction(), across = random.across(up) / 4;
        Scene scene = empty_scene(1, -10 * up, 0.5);
        add_plane(scene, "floor", up);
        add_sphere(scene, 0.125, 0.125 * up);
        for (const double side : {-1, 1}) {
            add_sphere(scene, 0.125, 0.125 * up + side * across);
            scene.spheres.back().fixed = true;
        }
        MemorySource run = recorded(scene);
        CAPTURE(n);
        CHECK(examined(run).holds());
        run.description.planes[0].offset = -100;
        CHECK(!examined(run).holds());
    }
}

TEST_CASE("a contact that closes together with another one needs no impulse of its own", "[verify]")
{
    // Past three balls it falls to the floor, and touches all of them at that instant.
    Scene scene = empty_scene(1.5, {0, 0, -10}, 0.5);
    for (int k = 0; k < 3; ++k) {
        add_sphere(scene, 0.125, {0.25 * std::cos(2.0943951023931953 * k), 0.25 * std::sin(2.0943951023931953 * k), 0});
        scene.spheres.back().fixed = true;
    }
    add_plane(scene, "floor", Vec3::UnitZ(), -0.125);
    add_sphere(scene, 0.125, {0, 0, 0.375});
    const Certificate past = examined(recorded(scene));
    INFO(first_violation(past));
    CHECK(past.holds());
}
