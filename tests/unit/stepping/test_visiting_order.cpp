#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// Overlaps (0,1) and (1,2) of three balls in a row after one pbd step from rest.
struct Overlaps {
    double left, right;
};

Overlaps overlaps_after(ContactOrder order, int passes, double left, double right)
{
    const Scene scene =
        scene_of({ball(0.1, Vec3(left - 0.2, 0, 0)), ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(0.2 - right, 0, 0))});
    PositionBased method{steps(0.01, 1, passes)};
    method.order = order;
    const auto final = run_discrete(scene, method, until(0.01)).final;
    return {0.2 - (final[1].position - final[0].position).norm(), 0.2 - (final[2].position - final[1].position).norm()};
}

}  // namespace

TEST_CASE("pbd is good for the last contact visited, and the order decides which that is", "[stepping]")
{
    // The first contact parts by its overlap; the second, now 3/2 deep, pushes half of that back: 3/4 remain in the
    // first.
    const double d = 0.02;
    const Overlaps index = overlaps_after(ContactOrder::index, 1, d, d);
    CHECK(index.left == Approx(0.75 * d));
    CHECK(index.right == Approx(0).margin(1e-15));
    const Overlaps reverse = overlaps_after(ContactOrder::reverse, 1, d, d);
    CHECK(reverse.left == Approx(0).margin(1e-15));
    CHECK(reverse.right == Approx(0.75 * d));
    const Overlaps left_first = overlaps_after(ContactOrder::deepest, 1, 0.03, 0.02);
    CHECK(left_first.left == Approx((0.015 + 0.02) / 2));
    CHECK(left_first.right == Approx(0).margin(1e-15));
    const Overlaps right_first = overlaps_after(ContactOrder::deepest, 1, 0.02, 0.03);
    CHECK(right_first.left == Approx(0).margin(1e-15));
}

TEST_CASE("Every further pass quarters the overlap that pbd leaves in a row of three", "[stepping]")
{
    double before = 0.75 * 0.02;
    for (const int passes : {2, 3, 4}) {
        const double left = overlaps_after(ContactOrder::index, passes, 0.02, 0.02).left;
        CHECK(left == Approx(before / 4));
        before = left;
    }
}

TEST_CASE("The order changes where spheres end under pbd and velocity; the same seed gives the same run", "[stepping]")
{
    Scene scene = gas(40, 0.1, 1.2, 5);  // falls into a heap
    scene.gravity = Vec3(0, 0, -9.81);
    scene.materials[0].restitution = 0.5;
    for (const Method& base : {Method(PositionBased{steps(1.0 / 60)}), Method(VelocityBased{steps(1.0 / 60)})}) {
        CAPTURE(name(base));
        const auto final = [&](ContactOrder order, std::uint64_t seed) {
            Method method = base;
            std::visit(
                [&](auto& m) {
                    if constexpr (!std::is_same_v<std::decay_t<decltype(m)>, EventDriven>) {
                        m.order = order;
                        m.seed = seed;
                    }
                },
                method);
            return run_discrete(scene, method, until(0.5)).final[7].position;
        };
        const Vec3 index = final(ContactOrder::index, 1);
        CHECK(final(ContactOrder::index, 2) == index);
        CHECK(final(ContactOrder::reverse, 1) != index);
        CHECK(final(ContactOrder::deepest, 1) != index);
        CHECK(final(ContactOrder::random, 1) != index);
        CHECK(final(ContactOrder::random, 1) == final(ContactOrder::random, 1));
        CHECK(final(ContactOrder::random, 2) != final(ContactOrder::random, 1));
    }
}

TEST_CASE("Among contacts at the same instant the order decides under bisection", "[stepping]")
{
    // Ball 1 hits two balls at once, symmetrically: whoever is served first takes more.
    const double x = std::sqrt(3.0) / 10;
    Scene scene = scene_of({ball(0.1, Vec3(0, 0.1001, 0)), ball(0.1, Vec3(-x - 0.1, 0, 0), Vec3(1, 0, 0)),
                            ball(0.1, Vec3(0, -0.1001, 0))});
    const auto speeds = [&](ContactOrder order) {
        Bisection method{steps(0.2)};
        method.order = order;
        const auto final = run_discrete(scene, method, until(0.2)).final;
        return std::pair(final[0].velocity.norm(), final[2].velocity.norm());
    };
    const auto index = speeds(ContactOrder::index), reverse = speeds(ContactOrder::reverse);
    CHECK(index.first > index.second + 0.1);
    CHECK(reverse.second == Approx(index.first));
    CHECK(reverse.first == Approx(index.second));
}
