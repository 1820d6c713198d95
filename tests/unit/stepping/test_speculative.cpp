#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

const Vec3 earth(0, 0, -9.81);
constexpr double dt = 1.0 / 60;

Speculative speculative(double step, Integrator integrator = Integrator::euler)
{
    Speculative method{steps(step)};
    method.integrator = integrator;
    return method;
}

/// A ball of radius 0.1 whose surface is `distance` from a wall and flies at it.
Scene thrown_at_wall(double distance, double speed, double restitution)
{
    Scene scene = scene_of({ball(0.1, Vec3(0.1 + distance, 0, 0), Vec3(-speed, 0, 0))}, {wall(Vec3::UnitX(), 0)});
    scene.materials[0].restitution = restitution;
    return scene;
}

/// A ball of radius 1/2 passes a resting one, `beside` it at the nearest.
Scene passing(double beside)
{
    return scene_of({ball(0.5, Vec3(-2, 1 + beside, 0), Vec3(10, 0, 0)), ball(0.5, Vec3::Zero())});
}

}  // namespace

TEST_CASE("speculative: a bullet passes no plate, however thin, at any phase; velocity lets most through", "[stepping]")
{
    std::mt19937_64 random(4);
    int through = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const double distance = 0.0105 + (1 + uniform(random)) * 1e4 * dt;
        const Scene scene =
            scene_of({ball(0.01, Vec3(-distance, 0, 0), Vec3(1e4, 0, 0))}, {plate(Vec3::UnitX(), 0, 0.001)});
        const Outcome outcome = run_discrete(scene, speculative(dt), until(6 * dt));
        REQUIRE(outcome.final[0].position.x() < -0.0105);
        REQUIRE(outcome.final[0].velocity.x() == Approx(-1e4));
        REQUIRE(outcome.counts.impacts == 1);
        REQUIRE(outcome.max_penetration < 1e-12);
        through += run_discrete(scene, VelocityBased{steps(dt)}, until(6 * dt)).final[0].position.x() > 0 ? 1 : 0;
    }
    CHECK(through > 950);
}

TEST_CASE("speculative: the rest of the step after a contact is lost", "[stepping]")
{
    // Contact at 0.35 of the third step: the rebound begins at its end.
    for (const double e : {0.0, 0.5, 1.0}) {
        const double speed = 3, h = 0.01, distance = 2.35 * h * speed;
        const Outcome outcome = run_discrete(thrown_at_wall(distance, speed, e), speculative(h), until(5 * h));
        CAPTURE(e);
        CHECK(outcome.final[0].velocity.x() == Approx(e * speed).margin(1e-14));
        CHECK(outcome.final[0].position.x() - 0.1 == Approx(e * speed * 2 * h).margin(1e-14));
        CHECK(outcome.counts.impacts == 1);
        CHECK(outcome.plane_impulses[0] == Approx((1 + e) * speed));
    }
}

TEST_CASE("speculative: who passes close by is struck in a wide step and not in a narrow one, the ghost impact",
          "[stepping]")
{
    for (const double step : {0.2, 1e-3}) {
        const Outcome outcome = run_discrete(passing(0.01), speculative(step), until(0.4));
        CAPTURE(step);
        CHECK((outcome.counts.impacts > 0) == (step == 0.2));
        CHECK((outcome.final[1].velocity.norm() > 1) == (step == 0.2));
    }
    // Beyond the margin of 0.04 radii there is no ghost, within it there is no miss.
    CHECK(run_discrete(passing(0.021), speculative(0.2), until(0.4)).counts.impacts == 0);
    CHECK(run_discrete(passing(-0.01), speculative(0.2), until(0.4)).counts.impacts == 1);
}

TEST_CASE("speculative: what is struck within a step passes nothing either, given the sweeps", "[stepping]")
{
    // The second ball stands between the bullet and a plate, and gets its speed within the step. A hundred sweeps hold
    // each back from the plate, but have not yet moved all of the bullet's impulse from the plate to the ball.
    const Scene scene = scene_of({ball(0.1, Vec3(-3, 0, 0), Vec3(1000, 0, 0)), ball(0.1, Vec3(-1, 0, 0))},
                                 {plate(Vec3::UnitX(), 0, 0.001)});
    for (const int sweeps : {100, 1000}) {
        Speculative method = speculative(dt);
        method.sweeps = sweeps;
        const Outcome outcome = run_discrete(scene, method, until(dt));
        CAPTURE(sweeps);
        CHECK(outcome.final[1].position.x() == Approx(-0.1005));
        CHECK(outcome.final[0].position.x() <= -0.1005 + 1e-12);
        CHECK((outcome.final[0].position.x() <= -0.3005 + 1e-12) == (sweeps == 1000));
    }
}

TEST_CASE("speculative: a ball lies still on the floor under any restitution and integrator", "[stepping]")
{
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola})
        for (const double e : {0.0, 0.5, 1.0}) {
            CAPTURE(e, static_cast<int>(integrator));
            const Outcome outcome = run_discrete(tower(1, e), speculative(dt, integrator), until(3));
            CHECK(outcome.final[0].position.z() == Approx(0.1).epsilon(1e-15));
            CHECK(outcome.final[0].velocity.norm() < 1e-15);
            CHECK(outcome.plane_impulses[0] == Approx(3 * 9.81));
        }
}

TEST_CASE("speculative: what does not bounce comes to lie on the floor, and slides along it", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1), Vec3(0.25, 0, 0))}, {wall(Vec3::UnitZ(), 0)}, earth);
    scene.materials[0].restitution = 0;
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola}) {
        const Outcome outcome = run_discrete(scene, speculative(0.0137, integrator), until(2));
        CHECK(outcome.max_penetration < 1e-15);
        CHECK(outcome.final[0].position.z() == Approx(0.1).epsilon(1e-14));
        CHECK(outcome.final[0].position.x() == Approx(0.5));
        CHECK(outcome.final[0].velocity.x() == 0.25);
    }
}

TEST_CASE("speculative: a tower of ten rests, and the floor carries all of it", "[stepping]")
{
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola})
        for (const double e : {0.0, 0.5}) {
            const Outcome outcome = run_discrete(tower(10, e), speculative(dt, integrator), until(10));
            CAPTURE(e, static_cast<int>(integrator));
            for (const BodyState& s : outcome.final) CHECK(s.velocity.norm() < 1e-6);
            CHECK(outcome.max_penetration < 1e-4);
            CHECK(outcome.plane_impulses[0] == Approx(10 * 10 * 9.81).epsilon(1e-4));
        }
}

TEST_CASE("speculative: an overlap goes by a fifth a step and leaves no velocity", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(0.15, 0, 0))});
    for (const int n : {1, 2, 10}) {
        const Outcome outcome = run_discrete(scene, speculative(0.01), until(0.01 * n));
        const double left = 0.2 - (outcome.final[1].position - outcome.final[0].position).norm();
        CHECK(left == Approx(0.05 * std::pow(0.8, n)));
        CHECK(outcome.final[0].velocity.norm() < 1e-15);
        CHECK(outcome.final[1].velocity.norm() < 1e-15);
    }
}

TEST_CASE("speculative: a contact that another one closes within the step is struck in the next", "[stepping]")
{
    // Three equal balls; the second closes on the third only because it is struck: impacts one after the other.
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 0), Vec3(1, 0, 0)), ball(0.1, Vec3(0.205, 0, 0), Vec3(0.1, 0, 0)),
                  ball(0.1, Vec3(0.4052, 0, 0), Vec3(0.2, 0, 0))});
    const Outcome outcome = run_discrete(scene, speculative(0.01), until(0.1));
    CHECK(outcome.final[0].velocity.x() == Approx(0.1).epsilon(1e-12));
    CHECK(outcome.final[1].velocity.x() == Approx(0.2).epsilon(1e-12));
    CHECK(outcome.final[2].velocity.x() == Approx(1).epsilon(1e-12));
}

TEST_CASE("speculative: the paths of many spheres are searched as those of few", "[stepping]")
{
    // With 200 far ones they are too many for all pairs: the few go the same way.
    Scene few = gas(60, 0.1, 1.6, 9);
    few.planes.clear();
    for (Sphere& s : few.spheres) s.velocity *= 10;
    Scene many = few;
    for (int k = 0; k < 200; ++k) many.spheres.push_back(ball(0.1, Vec3(100 + k, 50, 0)));
    many = scene_of(many.spheres);
    const Outcome a = run_discrete(few, speculative(dt), until(0.5)),
                  b = run_discrete(many, speculative(dt), until(0.5));
    CHECK(a.counts.impacts > 30);
    for (std::size_t i = 0; i < few.spheres.size(); ++i) CHECK(a.final[i].position == b.final[i].position);
}

TEST_CASE("speculative: tangential factors act where a sphere meets a plane, not where it lies on it", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1), Vec3(2, 0, 0))}, {wall(Vec3::UnitZ(), 0)}, earth);
    scene.materials[0] = Material{"felt", 0, 0.5, ""};
    CHECK(run_discrete(scene, speculative(1e-3), until(3)).final[0].velocity.x() == Approx(1).epsilon(1e-12));
}

TEST_CASE("speculative: no sweeps are refused", "[stepping]")
{
    Speculative method = speculative(dt);
    method.sweeps = 0;
    CHECK(run_discrete(tower(1, 0), method, until(1)).status == Status::unresolved);
}
