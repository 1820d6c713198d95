#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// Two balls of radius 0.1 that meet at half time, on a line through their centres.
Scene head_on(double mass_a = 1, double mass_b = 1)
{
    return scene_of(
        {ball(0.1, Vec3(-0.6, 0, 0), Vec3(1.5, 0, 0), mass_a), ball(0.1, Vec3(0.6, 0, 0), Vec3(-0.5, 0, 0), mass_b)});
}

Scene shifted(Scene scene, const Vec3& velocity)
{
    for (Sphere& s : scene.spheres) s.velocity += velocity;
    return scene;
}

}  // namespace

TEST_CASE("Equal masses swap velocities head on", "[stepping]")
{
    for (const double dt : {1.0 / 60, 1.0 / 1000}) {
        for (const Method& method : all_impulsive(steps(dt))) {
            CAPTURE(name(method), dt);
            const Outcome outcome = run_discrete(head_on(), method, until(1));
            CHECK((outcome.final[0].velocity - Vec3(-0.5, 0, 0)).norm() < 1e-15);
            CHECK((outcome.final[1].velocity - Vec3(1.5, 0, 0)).norm() < 1e-15);
            CHECK(outcome.counts.impacts == 1);
        }
    }
}

TEST_CASE("Unequal masses keep momentum and energy", "[stepping]")
{
    for (const Method& method : all_impulsive(steps(0.01))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(head_on(3, 1), method, until(1));
        CHECK(outcome.final[0].velocity.x() == Approx(0.5));
        CHECK(outcome.final[1].velocity.x() == Approx(2.5));
    }
}

TEST_CASE("Without attenuation a Galilean shift changes nothing else; attenuation breaks it", "[stepping]")
{
    const Vec3 shift(0, 7, 0);
    for (const Method& method : all_serious(steps(0.01))) {
        CAPTURE(name(method));
        Scene scene = head_on(3, 1);
        const auto momentum = [&](const Outcome& o) -> Vec3 { return 3 * o.final[0].velocity + o.final[1].velocity; };
        Outcome still = run_discrete(scene, method, until(1));
        Outcome moving = run_discrete(shifted(scene, shift), method, until(1));
        for (const std::size_t i : {0U, 1U})
            CHECK((moving.final[i].velocity - still.final[i].velocity - shift).norm() < 1e-13);
        CHECK((momentum(moving) - Vec3(4, 28, 0)).norm() < 1e-13);

        scene.contacts.push_back({0, 0, {}, {}, 0.9});
        still = run_discrete(scene, method, until(1));
        moving = run_discrete(shifted(scene, shift), method, until(1));
        CHECK((moving.final[0].velocity - still.final[0].velocity - shift).norm() == Approx(0.7));
        CHECK((momentum(moving) - 0.9 * Vec3(4, 28, 0)).norm() < 1e-13);
    }
}

TEST_CASE("Velocity leaves an existing overlap as it is; pbd removes it in one step", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(0.15, 0, 0))});
    const Outcome velocity = run_discrete(scene, VelocityBased{steps(0.01)}, until(1));
    CHECK(velocity.final[0].position == scene.spheres[0].position);
    CHECK(velocity.final[1].position == scene.spheres[1].position);
    CHECK(velocity.max_penetration == Approx(0.05));
    CHECK(velocity.counts.impacts == 0);
    const Outcome pbd = run_discrete(scene, PositionBased{steps(0.01)}, until(0.01));
    CHECK((pbd.final[0].position - Vec3(-0.025, 0, 0)).norm() < 1e-15);
    CHECK((pbd.final[1].position - Vec3(0.175, 0, 0)).norm() < 1e-15);
}

TEST_CASE("An overlap that approaches is turned back at once by velocity and bisection", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0), Vec3(1, 0, 0)), ball(0.1, Vec3(0.15, 0, 0))});
    for (const Method& method : {Method(VelocityBased{steps(0.01)}), Method(Bisection{steps(0.01)})}) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(0.1));
        CHECK(outcome.final[0].position.x() == 0);
        CHECK(outcome.final[1].position.x() == Approx(0.25));
        CHECK(outcome.counts.impacts == 1);
        CHECK(outcome.max_penetration ==
              Approx(0.04));  // after the first step; the scene's own 0.05 is not the method's
    }
}

TEST_CASE("Projection is half and half, or by inverse mass on request", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0), Vec3::Zero(), 3), ball(0.1, Vec3(0.16, 0, 0))});
    PositionBased method{steps(0.01)};
    CHECK(run_discrete(scene, method, until(0.01)).final[0].position.x() == Approx(-0.02));
    method.mass_weighted = true;
    const Outcome weighted = run_discrete(scene, method, until(0.01));
    CHECK(weighted.final[0].position.x() == Approx(-0.01));
    CHECK(weighted.final[1].position.x() == Approx(0.19));
}

TEST_CASE("Literal pbd turns separating spheres back, once a substep whatever the passes", "[stepping]")
{
    // Spheres 0 and 1 overlap and separate; 1 runs into 2. Each response swaps velocities.
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0), Vec3(-1, 0, 0)), ball(0.1, Vec3(0.15, 0, 0), Vec3(1, 0, 0)),
                                  ball(0.1, Vec3(0.3, 0, 0))});
    const auto velocities = [&](bool literal, int passes) {
        PositionBased method{steps(1e-6, 1, passes)};
        method.literal = literal;
        const Outcome outcome = run_discrete(scene, method, until(1e-6));
        return Vec3(outcome.final[0].velocity.x(), outcome.final[1].velocity.x(), outcome.final[2].velocity.x());
    };
    CHECK(velocities(false, 1) == Vec3(-1, 0, 1));
    CHECK(velocities(false, 2) == Vec3(-1, 0, 1));
    CHECK(velocities(true, 1) == Vec3(1, 0, -1));
    CHECK(velocities(true, 2) == Vec3(1, 0, -1));
}
