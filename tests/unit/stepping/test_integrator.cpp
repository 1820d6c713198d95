#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

StepOptions parabola(double dt, int substeps = 1)
{
    StepOptions options = steps(dt, substeps);
    options.integrator = Integrator::parabola;
    return options;
}

}  // namespace

TEST_CASE("With parabola free fall is exact, whatever the step is", "[stepping]")
{
    const Vec3 p0(1, 2, 30), v0(0.5, -1, 4), g(0.3, 0, -9.81);
    const Scene scene = scene_of({ball(0.1, p0, v0)}, {wall(Vec3::UnitZ(), 0)}, g);
    for (const double dt : {0.7, 1.0 / 60, 1.0 / 1000}) {
        for (const Method& method : all_discrete(parabola(dt, 2))) {
            CAPTURE(name(method), dt);
            const Outcome outcome = run_discrete(scene, method, until(0.7));
            CHECK((outcome.final[0].velocity - (v0 + 0.7 * g)).norm() < 1e-12);
            CHECK((outcome.final[0].position - (p0 + 0.7 * v0 + 0.245 * g)).norm() < 1e-11);
        }
    }
}

TEST_CASE("With parabola a fixed sphere stays where it is", "[stepping]")
{
    Sphere held = ball(0.1, Vec3(1, 2, 3));
    held.fixed = true;
    const Scene scene = scene_of({held, ball(0.1, Vec3(0, 0, 0))}, {}, Vec3(0, 0, -9.81));
    for (const Method& method : all_discrete(parabola(1.0 / 60))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(0.5));
        CHECK(outcome.final[0].position == Vec3(1, 2, 3));
        CHECK(outcome.final[0].velocity == Vec3::Zero());
    }
}

TEST_CASE("With parabola a ball that lies on the floor stays there", "[stepping]")
{
    for (const double e : {0.0, 0.5, 1.0}) {
        Scene scene = scene_of({ball(0.125, Vec3(0, 0, 0.125))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
        scene.materials[0].restitution = e;
        for (const Method& method : {Method(VelocityBased{parabola(1.0 / 60)}), Method(Moreau{parabola(1.0 / 60)})}) {
            CAPTURE(name(method), e);
            const Outcome outcome = run_discrete(scene, method, until(2));
            CHECK(outcome.final[0].position.z() == 0.125);
            CHECK(outcome.final[0].velocity == Vec3::Zero());
            CHECK(outcome.max_penetration == 0);
            // Weight of the ball for two units of time.
            CHECK(outcome.plane_impulses[0] == Approx(2 * 9.81));
        }
    }
}

TEST_CASE("With parabola a ball that slides down an incline is where the closed form has it", "[stepping]")
{
    // No friction: down the slope by g sin(angle) t^2 / 2. A hair deep, so that no rounding opens the contact for a
    // step.
    const double angle = 0.5, t = 1.5, height = 0.1 - 1e-13;
    const Vec3 n(std::sin(angle), 0, std::cos(angle)), down(std::cos(angle), 0, -std::sin(angle));
    for (const double e : {0.0, 0.5}) {
        Scene scene = scene_of({ball(0.1, height * n)}, {wall(n, 0)}, Vec3(0, 0, -9.81));
        scene.materials[0].restitution = e;
        for (const Method& method : {Method(VelocityBased{parabola(1.0 / 60)}), Method(Moreau{parabola(1.0 / 60)})}) {
            CAPTURE(name(method), e);
            const Outcome outcome = run_discrete(scene, method, until(t));
            const Vec3 exact = height * n + (9.81 * std::sin(angle) * t * t / 2) * down;
            CHECK((outcome.final[0].position - exact).norm() < 1e-12);
            CHECK((outcome.final[0].velocity - 9.81 * std::sin(angle) * t * down).norm() < 1e-12);
        }
    }
}

TEST_CASE(
    "With parabola an elastic ball keeps its energy to rounding under velocity and moreau, bounce after "
    "bounce",
    "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    const auto energy = [](const BodyState& s) { return s.velocity.squaredNorm() / 2 + 9.81 * s.position.z(); };
    for (const Method& method : {Method(VelocityBased{parabola(1.0 / 240)}), Method(Moreau{parabola(1.0 / 240)})}) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(10));
        CHECK(outcome.counts.impacts > 8);
        CHECK(energy(outcome.final[0]) == Approx(9.81 * 1.1).epsilon(1e-12));
    }
}

TEST_CASE("With parabola bisection and a bounce agree with the closed form to the last digits", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    scene.materials[0].restitution = 0.8;
    const double hit = std::sqrt(2 / 9.81), up = 0.8 * 9.81 * hit, t = 0.3;
    const Outcome outcome = run_discrete(scene, Bisection{parabola(1.0 / 60)}, until(hit + t));
    CHECK(outcome.counts.impacts == 1);
    CHECK(outcome.final[0].position.z() == Approx(0.1 + up * t - 9.81 * t * t / 2).epsilon(1e-13));
    CHECK(outcome.final[0].velocity.z() == Approx(up - 9.81 * t).epsilon(1e-13));
}

TEST_CASE("With parabola a ball comes to rest on the floor under bisection", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    scene.materials[0].restitution = 0.8;
    const Outcome outcome = run_discrete(scene, Bisection{parabola(1.0 / 60)}, until(5));
    CHECK(outcome.final[0].position.z() == Approx(0.1).margin(1e-15));
    CHECK(outcome.final[0].velocity == Vec3::Zero());
    CHECK(outcome.max_penetration < 1e-15);
}

TEST_CASE("With parabola moreau brings what does not bounce onto the floor, not into it", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0.5)), ball(0.1, Vec3(0.01, 0, 0.8))}, {wall(Vec3::UnitZ(), 0)},
                           Vec3(0, 0, -9.81));
    scene.materials[0].restitution = 0;
    const Outcome outcome = run_discrete(scene, Moreau{parabola(1.0 / 60)}, until(1));
    CHECK(outcome.max_penetration < 1e-3);
    CHECK(outcome.final[0].position.z() >= 0.1 - 1e-9);
    CHECK(outcome.final[0].velocity.norm() < 1);
}

TEST_CASE("Integrators have names", "[stepping]")
{
    CHECK(name(integrator("parabola")) == "parabola");
    CHECK(integrator("euler") == Integrator::euler);
    CHECK_THROWS_WITH(integrator("rk4"), Catch::Contains("euler, parabola"));
}
