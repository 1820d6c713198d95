#include "exactly.hpp"

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double tiny = 1e-25;

Scene groove(double restitution, double height)
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.materials[0].restitution = restitution;
    const double h = std::sqrt(0.5);
    scene.planes = {plane("left", {h, 0, h}, 0), plane("right", {-h, 0, h}, 0)};
    scene.spheres = {ball("ball", {0, 0, 0.1 / h + height}, {0, 0, 0})};
    return scene;
}

Scene fixed_balls(const Vec3& x, const Vec3& v)
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.spheres = {ball("rock", {0, 0, 0}, {0, 0, 0}, 1, 1), ball("ball", x, v, 1, 0.1)};
    scene.spheres[0].fixed = true;
    return scene;
}

}  // namespace

TEST_CASE("A ball in a groove comes to rest at sqrt(2) r, at the end of its geometric series", "[reference]")
{
    const double e = 0.5, height = 0.5;
    const Scene scene = groove(e, height);
    const Exact run = exactly(scene, 3);
    REQUIRE_FALSE(run.stopped());
    CHECK(run.mode(0, 3) == Mode::resting);
    const ExactVector x = run.flight(0).position(3);
    CHECK(off(x, {0, 0, sqrt(Real(2)) / 10}) < 1e-16);  // planes and radius are doubles
    CHECK(off(run.flight(0).velocity(3), {}) == 0);

    const Real g(9.81), n = Real(std::sqrt(0.5)), fall = Real(scene.spheres[0].position.z()) - Real(0.1) / n;
    const Real rest = sqrt(2 * fall / g) * (1 + e) / (1 - e);
    CHECK(abs(run.flight(0).t - rest) < 1e-26);
    CHECK(run.record.impacts.size() > 100);  // 53 bounces on both until doubles do not tell them apart
    REQUIRE(run.record.since.size() == 2);
    CHECK(exactly(scene, static_cast<double>(rest) - 1e-9).mode(0, rest) == Mode::flying);
}

TEST_CASE("A ball slides along a groove that slopes", "[reference]")
{
    Scene scene = groove(0.5, 0);
    scene.gravity = {0, 2, -9.81};
    const Exact run = exactly(scene, 3);
    CHECK(run.mode(0, 3) == Mode::sliding);
    CHECK(off(run.flight(0).position(3) - run.flight(0).x, {0, 9, 0}) < tiny);
}

TEST_CASE("A ball in a corner of three planes rests, on one plane it slides", "[reference]")
{
    Scene scene;
    scene.gravity = {-1, -2, -9.81};
    scene.spheres = {ball("ball", {0.5, 0.5, 0.5}, {0, 0, 0}, 1, 0.5)};
    scene.planes = {plane("x", {1, 0, 0}, 0), plane("y", {0, 1, 0}, 0), plane("z", {0, 0, 1}, 0)};
    CHECK(exactly(scene, 2).mode(0, 2) == Mode::resting);
    scene.gravity.y() = 2;  // away from one of them
    const Exact run = exactly(scene, 2);
    CHECK(run.mode(0, 2) == Mode::sliding);
    CHECK(off(run.flight(0).position(2), {Real(0.5), Real(4.5), Real(0.5)}) < tiny);
}

TEST_CASE("A tower stands, whatever its height", "[reference]")
{
    for (const int n : {2, 5, 100}) {
        Scene scene;
        scene.gravity = {0, 0, -9.81};
        for (int i = 0; i < n; ++i)
            scene.spheres.push_back(ball("b" + std::to_string(i), {0, 0, i + 0.5}, {0, 0, 0}, 1, 0.5));
        scene.planes = {plane("floor", {0, 0, 1}, 0)};
        const Exact run = exactly(scene, 1e6);
        REQUIRE(run.reason() == "");
        CHECK(run.record.impacts.empty());
        for (BodyId i = 0; i < n; ++i) {
            CHECK(run.mode(i, 1e6) == Mode::resting);
            CHECK(off(run.flight(i).position(1e6), {0, 0, i + Real(0.5)}) == 0);
        }
    }
}

TEST_CASE("A tower that gravity tilts falls, a row on a slope slides together", "[reference]")
{
    Scene scene;
    scene.gravity = {1, 0, -8};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    scene.spheres = {ball("a", {0, 0, 0.5}, {0, 0, 0}, 1, 0.5), ball("b", {1, 0, 0.5}, {0, 0, 0}, 3, 0.5),
                     ball("c", {1, 1, 0.5}, {0, 0, 0}, 2, 0.5)};
    const Exact run = exactly(scene, 2);
    REQUIRE(run.reason() == "");
    for (BodyId i = 0; i < 3; ++i) {
        CHECK(run.mode(i, 2) == Mode::sliding);
        CHECK(off(run.flight(i).velocity(2), {2, 0, 0}) < tiny);
    }
}

TEST_CASE("A row on a slope that a wall stops rests against it", "[reference]")
{
    Scene scene;
    scene.gravity = {1, 0, -8};
    scene.materials[0].restitution = 0;
    scene.planes = {plane("floor", {0, 0, 1}, 0), plane("wall", {-1, 0, 0}, -3.5)};
    scene.spheres = {ball("a", {0, 0, 0.5}, {0, 0, 0}, 1, 0.5), ball("b", {1, 0, 0.5}, {0, 0, 0}, 3, 0.5)};
    const Exact run = exactly(scene, 4);  // 2 to go: t = 2, at speed 2
    REQUIRE(run.reason() == "");
    CHECK(run.mode(0, 4) == Mode::resting);
    CHECK(run.mode(1, 4) == Mode::resting);
    CHECK(off(run.flight(0).position(4), {2, 0, Real(0.5)}) < tiny);
    CHECK(run.record.impacts.size() == 2);
}

TEST_CASE("A pressed contact opens where its bodies part faster than the force can bend their paths", "[reference]")
{
    Scene scene;
    scene.gravity = {1, 0, -8};
    scene.planes = {plane("floor", {0, 0, 1}, 0), plane("wall", {-1, 0, 0}, -1.5)};
    scene.spheres = {ball("at the wall", {1, 0, 0.5}, {0, 0, 0}, 1, 0.5),
                     ball("behind", {0, 0, 0.5}, {0, 0, 0}, 1, 0.5),
                     ball("cue", {-0.25, 3, 0.5}, {0.25, -4, 0}, 1, 0.5)};
    const Exact run = exactly(scene, 0.625);  // hits at t = 1/2 along y, at (0, 1), where its velocity is (3/4, -4)
    REQUIRE(run.reason() == "");
    CHECK(run.mode(0, 0.625) == Mode::resting);
    CHECK(off(run.flight(1).velocity(0.625), {Real(0.125), -4, 0}) < tiny);
    CHECK(off(run.flight(2).velocity(0.625), {Real(0.875), 0, 0}) < tiny);
    scene.spheres[2].position.x() = -4;         // hits at t = 4
    scene.spheres[2].velocity = {-1, -0.5, 0};  // 1/4 / (r1 + r2) is less than gravity
    const Exact pressed = exactly(scene, 4.1);
    REQUIRE(pressed.reason() == "");
    CHECK(pressed.mode(2, 4.1) == Mode::sliding);
    CHECK(pressed.record.since.count({0, 1}) == 1);
}

TEST_CASE("A ball rests on top of a fixed one, and in the hollow of three", "[reference]")
{
    const Exact top = exactly(fixed_balls({0, 0, 1.1}, {0, 0, 0}), 10);
    CHECK(top.reason() == "");
    CHECK(top.mode(1, 10) == Mode::resting);

    Scene scene;
    scene.gravity = {0, 0, -9.81};
    const double h = std::sqrt(0.75);
    for (int k = 0; k < 3; ++k) {
        scene.spheres.push_back(ball("rock-" + std::to_string(k), {k / 2.0, k == 1 ? h : 0, 0}, {0, 0, 0}, 1, 0.5));
        scene.spheres.back().fixed = true;
    }
    scene.spheres.push_back(ball("ball", {0.5, h / 3, std::sqrt(2.0 / 3)}, {0, 0, 0}, 1, 0.5));
    const Exact run = exactly(scene, 10);
    CHECK(run.reason() == "");
    CHECK(run.mode(3, 10) == Mode::resting);
}

TEST_CASE("Spheres bounce to rest side by side, and are hit again", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -2};
    scene.materials[0].restitution = 0.5;
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    scene.spheres = {ball("low", {0, 0, 1.5}, {0, 0, 0}, 1, 0.5), ball("high", {0, 0, 20.5}, {0, 0, 0}, 1, 0.5)};
    // 1 m: t = 1, in all 3 until rest; the other falls 19 m to the top of the resting one, t = sqrt(19).
    const Exact rest = exactly(scene, 4);
    CHECK(rest.mode(0, 4) == Mode::resting);
    REQUIRE(rest.record.series.size() == 1);
    CHECK(rest.record.series[0].end == Approx(3).epsilon(1e-15));
    const Exact hit = exactly(scene, 4.5);
    REQUIRE(hit.reason() == "");
    CHECK(hit.record.impacts.back().time == Approx(std::sqrt(19.0)).epsilon(1e-15));
    CHECK(hit.record.impacts.size() == rest.record.impacts.size() + 2);
    CHECK(hit.mode(1, 4.5) == Mode::flying);
    // P_all stops the falling one, reflections send it back; e is that of the contact that closes.
    CHECK(static_cast<double>(hit.flight(1).v.z) == Approx(0.5 * std::sqrt(2 * 2 * 19.0)).epsilon(1e-15));
    const Exact over = exactly(scene, 60);
    REQUIRE(over.reason() == "");
    CHECK(over.mode(0, 60) == Mode::resting);
    CHECK(over.mode(1, 60) == Mode::resting);
    CHECK(off(over.flight(1).position(60), {0, 0, Real(1.5)}) < tiny);
}
