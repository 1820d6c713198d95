#include "flight/flight.hpp"

#include "support/multiprecision.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("the separation of two places forgets how far away both are")
{
    Random random(1);
    const Frame frame{1, 1};
    for (int i = 0; i < 2000; ++i) {
        Place a = place_at(frame, random.in_cube(3) + Vec3::Constant(4)),
              b = place_at(frame, random.in_cube(3) + Vec3::Constant(4));
        const Vec3 r = separation(frame, a, b);
        for (int k = 0; k < 3; ++k) {
            const Float200 exact =
                Float200(a.cell[k]) + Float200(a.local[k]) - Float200(b.cell[k]) - Float200(b.local[k]);
            CHECK(abs(Float200(r[k]) - exact) <= 0x1p-52 * (abs(exact) + 1));
            a.cell[k] += std::int64_t{1} << 50;
            b.cell[k] += std::int64_t{1} << 50;
        }
        CHECK(separation(frame, a, b) == r);
        CHECK(separation(frame, b, a) == -r);
    }
}

TEST_CASE("a displacement is that of the parabola")
{
    CHECK(displacement({1, 2, 3}, {0, 0, -10}, 2) == Vec3(2, 4, -14));
    CHECK(displacement({1, 2, 3}, {0, 0, -10}, 0) == Vec3(0, 0, 0));
}

TEST_CASE("accelerations: none without gravity, along a plane without its normal part, exactly 0 along a level floor")
{
    Scene scene = empty_scene(1);
    add_floor(scene);
    const Accelerations still(scene);
    CHECK_FALSE(still.has_gravity());
    CHECK(still.free() == Accelerations::none);
    CHECK(still.along(0) == Accelerations::none);
    CHECK(still[Accelerations::none] == Vec3::Zero());

    scene.gravity = earth;
    const double angle = 0.3;
    add_plane(scene, "incline", {std::sin(angle), 0, std::cos(angle)});
    add_plane(scene, "almost level", {1e-17, 0, 1});
    const Accelerations falling(scene);
    CHECK(falling[falling.free()] == earth);
    CHECK(falling[falling.along(0)] == Vec3::Zero());
    const Vec3 along = falling[falling.along(1)];
    CHECK(along.norm() == Approx(9.81 * std::sin(angle)).epsilon(1e-15));
    CHECK(std::abs(along.dot(scene.planes[1].normal)) <= 1e-15 * 9.81);
    CHECK(falling[falling.along(2)] == Vec3::Zero());
}
