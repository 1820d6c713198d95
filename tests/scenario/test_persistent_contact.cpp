// Known answers of contacts that stay: rest, slides, forces, leaving. Forces are what planes took over a run, by its
// length. Sources and closed forms stand with each.
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double g = 9.81;

/// Mean normal force on a plane [mass length/time^2].
double force(const Outcome& outcome, std::size_t plane)
{
    return outcome.plane_impulses[plane] / outcome.time;
}

/// A run in which nothing may happen.
Outcome stands_still(const Scene& scene)
{
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == Status::reached_end);
    CHECK(run.events.empty());
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        INFO("sphere " << i);
        CHECK(run.outcome.final[i].velocity == Vec3::Zero());
        CHECK((run.outcome.final[i].position - scene.spheres[i].position).norm() <= 1e-12);
        CHECK(run.outcome.final[i].mode == (scene.spheres[i].fixed ? Mode::fixed : Mode::resting));
    }
    return run.outcome;
}

Scene tower(int n, double radius, double end_time, double restitution = 0.5)
{
    Scene scene = empty_scene(end_time, earth, restitution);
    add_floor(scene);
    for (int k = 0; k < n; ++k) add_sphere(scene, radius, {0, 0, (2 * k + 1) * radius});
    return scene;
}

Scene v_groove(double end_time, double restitution = 0.5)
{
    Scene scene = empty_scene(end_time, earth, restitution);
    add_plane(scene, "left", {1, 0, 1});
    add_plane(scene, "right", {-1, 0, 1});
    return scene;
}

/// Centres of three equal touching balls around the z axis, at this height.
std::vector<Vec3> triangle(double radius, double z)
{
    const double side = 2 * radius, r = side / std::sqrt(3.0);
    return {{r, 0, z}, {-r / 2, side / 2, z}, {-r / 2, -side / 2, z}};
}

/// A ball of radius 0.1 on a fixed one of radius 1, at `angle` from the top, moving down at `speed` along it.
Scene on_a_globe(double angle, double speed, double end_time)
{
    Scene scene = empty_scene(end_time, earth, 0.5);
    add_sphere(scene, 1, Vec3::Zero());
    scene.spheres[0].fixed = true;
    add_sphere(scene, 0.1, 1.1 * Vec3(std::sin(angle), 0, std::cos(angle)),
               speed * Vec3(std::cos(angle), 0, -std::sin(angle)));
    return scene;
}

/// When and where the ball leaves.
struct Leaving {
    double time = 0, cosine = 0;
};
Leaving leaving(const Scene& scene)
{
    Leaving found;
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == Status::reached_end);
    int releases = 0;
    for (const Event& e : run.events)
        if (e.kind == EventKind::release) {
            ++releases;
            found.time = e.time;
        }
    CHECK(releases == 1);
    CHECK(run.outcome.counts.releases == 1);
    RunOptions options;
    options.until = found.time;
    const BodyState ball = record(scene, EventDriven{}, options).outcome.final[1];
    found.cosine = ball.position.z() / ball.position.norm();
    // Up to there the energy says how fast it is.
    const double start = 9.81 * scene.spheres[1].position.z() + 0.5 * scene.spheres[1].velocity.squaredNorm();
    CHECK(0.5 * ball.velocity.squaredNorm() + 9.81 * ball.position.z() == Approx(start).epsilon(1e-6));
    return found;
}

}  // namespace

TEST_CASE("a sphere leaves a fixed one at cos = 2/3 + v0^2 / (3 g (R + r))")
{
    const Leaving pushed = leaving(on_a_globe(0, 0.1, 1.5));
    CHECK(pushed.cosine == Approx(2.0 / 3 + 0.01 / (3 * g * 1.1)).margin(1e-6));
    CHECK(pushed.time == Approx(1.348320124121080).margin(1e-6));  // quadrature in 40 digits
    const Leaving released = leaving(on_a_globe(3.14159265358979323846 / 18, 0, 1));
    CHECK(released.cosine == Approx(0.656538502).margin(1e-6));
    CHECK(released.time == Approx(0.766988526).margin(1e-6));
}

TEST_CASE("a sphere exactly on top of a fixed one stays there")
{
    stands_still(on_a_globe(0, 0, 1000));
}

TEST_CASE("after it left, a sphere falls as any other")
{
    // Leaves at 1.348320124 with 2.682784623 at 48.16 degrees; from there a parabola (40 digits).
    const BodyState ball = record(on_a_globe(0, 0.1, 1.5)).outcome.final[1];
    CHECK((ball.position - Vec3(1.0909962059432338, 0, 0.3176337499052403)).norm() <= 1e-5);
    CHECK((ball.velocity - Vec3(1.789351792528545, 0, -3.4868676472493286)).norm() <= 1e-5);
    CHECK(ball.mode == Mode::flying);
}

TEST_CASE("a ball rests on three fixed ones that touch")
{
    Scene scene = empty_scene(100, earth, 0.5);
    for (const Vec3& p : triangle(0.1, 0)) {
        add_sphere(scene, 0.1, p);
        scene.spheres.back().fixed = true;
    }
    add_sphere(scene, 0.1, {0, 0, 0.2 * std::sqrt(2.0 / 3)});
    stands_still(scene);
}

TEST_CASE("each of three supports under a ball carries 0.408248 of its weight")
{
    // Planes in place of the three balls: the same normals.
    Scene scene = empty_scene(10, earth, 0.5);
    const double m = 3;
    for (const Vec3& p : triangle(0.1, -0.2 * std::sqrt(2.0 / 3))) {
        add_plane(scene, "support " + std::to_string(scene.planes.size()), -p);
        scene.planes.back().offset = -0.1;
    }
    add_sphere(scene, 0.1, Vec3::Zero(), Vec3::Zero(), m);
    const Outcome outcome = stands_still(scene);
    for (std::size_t p = 0; p < 3; ++p) CHECK(force(outcome, p) == Approx(m * g / std::sqrt(6.0)).margin(1e-9 * m * g));
    CHECK(1 / std::sqrt(6.0) == Approx(0.408248).margin(1e-6));
}

TEST_CASE("three balls on a floor, each against a wall, carry a fourth: what floor and walls take shows its contacts")
{
    const double r = 0.1, m = 2;
    Scene scene = empty_scene(10, earth, 0.5);
    add_floor(scene);
    for (const Vec3& p : triangle(r, r)) {
        const Vec3 out(p.x(), p.y(), 0);
        add_plane(scene, "wall " + std::to_string(scene.planes.size()), -out);
        scene.planes.back().offset = -(out.norm() + r);
        add_sphere(scene, r, p);
    }
    add_sphere(scene, r, {0, 0, r + 2 * r * std::sqrt(2.0 / 3)}, Vec3::Zero(), m);
    const Outcome outcome = stands_still(scene);
    const double contact = m * g / std::sqrt(6.0);
    CHECK(force(outcome, 0) == Approx((3 + m) * g).margin(1e-9 * m * g));
    for (std::size_t p = 1; p < 4; ++p)
        CHECK(force(outcome, p) == Approx(contact / std::sqrt(3.0)).margin(1e-9 * m * g));
}

TEST_CASE("contact k from the top of a tower carries k m g")
{
    for (const int n : {1, 2, 3, 10}) {
        const Outcome outcome = stands_still(tower(n, 0.1, 10));
        CHECK(force(outcome, 0) == Approx(n * g).margin(1e-9 * n * g));
    }
    // Unequal ones: what lies above counts, by mass.
    Scene scene = tower(3, 0.1, 10);
    for (std::size_t k = 0; k < 3; ++k) scene.spheres[k].mass = std::pow(10, k);
    CHECK(force(stands_still(scene), 0) == Approx(111 * g).epsilon(1e-9));
}

TEST_CASE("a tower of 100 stands for a million seconds, without events, in no time")
{
    const Scene scene = tower(100, 0.125, 1e6);
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = stands_still(scene);
    const double milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    CHECK(force(outcome, 0) == Approx(100 * g).epsilon(1e-9));
    CHECK(milliseconds < 200);  // 10 ms are asked for where nothing else runs
}

TEST_CASE("a row on a slope leans on its wall with m g sin of every ball")
{
    const double theta = 0.4, r = 0.1;
    const int n = 7;
    Scene scene = empty_scene(10, earth, 0.5);
    const Vec3 up(std::sin(theta), 0, std::cos(theta)), down(std::cos(theta), 0, -std::sin(theta));
    add_plane(scene, "slope", up);
    add_plane(scene, "wall", -down);
    for (int k = 0; k < n; ++k) add_sphere(scene, r, r * scene.planes[0].normal - (2 * k + 1) * r * down);
    const Outcome outcome = stands_still(scene);
    CHECK(force(outcome, 0) == Approx(n * g * std::cos(theta)).epsilon(1e-9));
    CHECK(force(outcome, 1) == Approx(n * g * std::sin(theta)).epsilon(1e-9));
}

TEST_CASE("a sphere of radius 0.1 rests in a right-angled groove at 0.141421356, held by 0.707107 of its weight twice")
{
    Scene scene = v_groove(10);
    const double m = 2, height = 0.1 * std::sqrt(2.0);
    CHECK(height == Approx(0.141421356).margin(1e-9));
    add_sphere(scene, 0.1, {0, 0, height}, Vec3::Zero(), m);
    const Outcome outcome = stands_still(scene);
    for (const std::size_t p : {0u, 1u})
        CHECK(force(outcome, p) == Approx(m * g / std::sqrt(2.0)).margin(1e-9 * m * g));
}

TEST_CASE("a sphere slides along a groove, level or falling, as a straight line says")
{
    for (const double slope : {0.0, 0.3}) {
        Scene scene = v_groove(3);
        for (Plane& p : scene.planes) p.normal = Vec3(p.normal.x(), slope, p.normal.z()).normalized();
        // Along the line in both planes.
        const Vec3 along = scene.planes[0].normal.cross(scene.planes[1].normal).normalized();
        const Vec3 middle = (scene.planes[0].normal + scene.planes[1].normal).normalized();
        const double out = 0.1 / middle.dot(scene.planes[0].normal);
        add_sphere(scene, 0.1, out * middle, 0.5 * along);
        const Recorded run = record(scene);
        INFO("slope " << slope << " " << run.outcome.message);
        REQUIRE(run.outcome.status == Status::reached_end);
        CHECK(run.events.empty());
        const double a = earth.dot(along);
        const BodyState& s = run.outcome.final[0];
        CHECK((s.position - scene.spheres[0].position - (0.5 * 3 + a * 4.5) * along).norm() <= 1e-11);
        CHECK((s.velocity - (0.5 + 3 * a) * along).norm() <= 1e-12);
        CHECK(s.mode == Mode::sliding);
        const double across = (earth - a * along).norm() / (2 * middle.dot(scene.planes[0].normal));
        CHECK(force(run.outcome, 0) == Approx(across).margin(1e-9 * g));
    }
}

TEST_CASE("a sphere dropped into a groove comes to rest in it")
{
    Scene scene = v_groove(20);
    add_sphere(scene, 0.1, {0.03, 0, 0.6});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == Status::reached_end);
    const BodyState& s = run.outcome.final[0];
    CHECK((s.position - Vec3(0, 0, 0.1 * std::sqrt(2.0))).norm() <= 1e-9);
    CHECK(s.velocity == Vec3::Zero());
    CHECK(s.mode == Mode::resting);
    CHECK(run.outcome.rest_times[0].has_value());
    CHECK(run.outcome.counts.guarded == 0);
}

TEST_CASE("a row of plastic balls goes on together, and apart where nothing holds it")
{
    Scene scene = empty_scene(2, Vec3::Zero(), 0);
    for (int i = 0; i < 4; ++i)
        add_sphere(scene, 0.5, {1.0 * i - (i == 0 ? 0.25 : 0), 0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == Status::reached_end);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK((run.outcome.final[i].position - Vec3(static_cast<double>(i) + 1.75 / 4, 0, 0)).norm() <= 1e-12);
}

TEST_CASE("a contact that nothing presses opens without an impact")
{
    Scene scene = empty_scene(1, earth, 0.5);
    add_plane(scene, "ceiling", -Vec3::UnitZ());
    add_sphere(scene, 0.5, {0, 0, -0.5});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    CHECK(run.outcome.counts.impacts == 0);
    CHECK(run.outcome.final[0].position.z() == Approx(-0.5 - g / 2).epsilon(1e-13));
    CHECK(run.outcome.final[0].mode == Mode::flying);
}

TEST_CASE("a pyramid of four comes apart, and its top leaves where h^3 + 6 r^2 h = 4 r^2 h0")
{
    // R^2 + h^2 = 4 r^2 and energy; the time is a quadrature in 40 digits.
    const double r = 0.1, h0 = 2 * r * std::sqrt(2.0 / 3), speed = 0.4564407902767314, leave = 0.2460823900956200;
    Scene scene = empty_scene(0.3, earth, 0.5);
    add_floor(scene);
    for (const Vec3& p : triangle(r, r)) add_sphere(scene, r, p);
    add_sphere(scene, r, {0, 0, r + h0});
    const Recorded run = record(scene);
    INFO(run.outcome.message);
    REQUIRE(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.counts.impacts == 0);
    double last = 0;
    for (const Event& e : run.events)
        if (e.kind == EventKind::release) last = std::max(last, e.time);
    CHECK(last == Approx(leave).margin(1e-6));
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 out = Vec3(scene.spheres[k].position.x(), scene.spheres[k].position.y(), 0).normalized();
        CHECK((run.outcome.final[k].velocity - speed * out).norm() <= 1e-6);
        CHECK((run.outcome.final[k].position - 0.2007646636972195 * out - r * Vec3::UnitZ()).norm() <= 1e-6);
    }
    CHECK((run.outcome.final[3].position - Vec3(0, 0, 0.1346742811353411)).norm() <= 1e-6);
    CHECK(run.outcome.body_seconds.numeric > 0);
    CHECK(run.outcome.body_seconds.guarded == 0);
}
