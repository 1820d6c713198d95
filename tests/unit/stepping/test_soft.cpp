#include "run_all.hpp"
#include "small_scenes.hpp"
#include "stepping/soft_constraint.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double dt = 1.0 / 60;

Soft soft(double step, int substeps = 4, Integrator integrator = Integrator::euler)
{
    Soft method{steps(step, substeps)};
    method.integrator = integrator;
    return method;
}

}  // namespace

TEST_CASE("A soft constraint ends a substep as implicit Euler ends that of a damped spring", "[stepping]")
{
    // v' = v - h (w^2 s' + 2 z w v'), s' = s + h v', solved for v'.
    for (const double hertz : {1.0, 30.0, 1e4})
        for (const double zeta : {0.0, 0.5, 10.0})
            for (const double h : {1e-4, 1.0 / 240}) {
                const double w = 2 * std::numbers::pi * hertz, s = -0.01, v = -0.3;
                const double expected = (v - h * w * w * s) / (1 + 2 * zeta * w * h + w * w * h * h);
                const stepping::Softness softness = stepping::make_softness(hertz, zeta, h);
                const double impulse_by_mass = -softness.mass_scale * (v + softness.bias_rate * s);
                CAPTURE(hertz, zeta, h);
                CHECK(v + impulse_by_mass == Approx(expected));
                // A second pass over a contact that is alone adds nothing.
                const double again = -softness.mass_scale * (v + impulse_by_mass + softness.bias_rate * s) -
                                     softness.impulse_scale * impulse_by_mass;
                CHECK(again == Approx(0).margin(1e-9));
            }
}

TEST_CASE("soft: a ball rebounds at e times its speed, at the end of the step in which it meets the wall", "[stepping]")
{
    for (const double e : {0.0, 0.5, 1.0})
        for (const int substeps : {1, 4}) {
            const double speed = 3, h = 0.01, distance = 2.35 * h * speed;
            Scene scene =
                scene_of({ball(0.1, Vec3(0.1 + distance, 0, 0), Vec3(-speed, 0, 0))}, {wall(Vec3::UnitX(), 0)});
            scene.materials[0].restitution = e;
            const Outcome outcome = run_discrete(scene, soft(h, substeps), until(5 * h));
            CAPTURE(e, substeps);
            CHECK(outcome.final[0].velocity.x() == Approx(e * speed).margin(1e-14));
            CHECK(outcome.final[0].position.x() - 0.1 == Approx(e * speed * 2 * h).margin(1e-14));
            CHECK(outcome.counts.impacts == 1);
            CHECK(outcome.plane_impulses[0] == Approx((1 + e) * speed));
        }
}

TEST_CASE("soft: a ball lies still on the floor under any restitution and integrator", "[stepping]")
{
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola})
        for (const double e : {0.0, 0.5, 1.0}) {
            const Outcome outcome = run_discrete(tower(1, e), soft(dt, 4, integrator), until(3));
            CAPTURE(e, static_cast<int>(integrator));
            CHECK(outcome.final[0].position.z() == Approx(0.1).margin(1e-4));
            CHECK(outcome.final[0].velocity.norm() < 1e-12);
            CHECK(outcome.plane_impulses[0] == Approx(3 * 9.81).epsilon(1e-3));
        }
}

TEST_CASE("soft: a tower of ten comes to rest with an overlap that does not grow", "[stepping]")
{
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola}) {
        const Outcome five = run_discrete(tower(10, 0.5), soft(dt, 4, integrator), until(5));
        const Outcome ten = run_discrete(tower(10, 0.5), soft(dt, 4, integrator), until(10));
        for (std::size_t i = 0; i < 10; ++i) {
            CHECK(ten.final[i].velocity.norm() < 1e-3);
            CHECK((ten.final[i].position - five.final[i].position).norm() < 1e-3);
        }
        CHECK(ten.max_penetration < 0.01);
    }
}

TEST_CASE("soft: an overlap goes without leaving a velocity, no faster than a tenth of a diameter a period",
          "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(0.12, 0, 0))});
    const double fastest = 0.1 * 0.2 * 30;
    double before = 0.08;
    for (const double time : {dt, 2 * dt, 10 * dt, 60 * dt}) {
        const Outcome outcome = run_discrete(scene, soft(dt), until(time));
        const double left = 0.2 - (outcome.final[1].position - outcome.final[0].position).norm();
        CAPTURE(time);
        CHECK(left < before);
        CHECK(left >= 0.08 - fastest * time - 1e-12);
        CHECK(outcome.final[0].velocity.norm() < 1e-12);
        before = left;
    }
    CHECK(before < 0.01);
    // Less damping parts faster; and meets the limit, with the mass scale of its softness.
    Soft eager = soft(dt);
    eager.damping_ratio = 0.1;
    const Outcome outcome = run_discrete(scene, eager, until(dt));
    CHECK((outcome.final[1].position - outcome.final[0].position).norm() > 0.12 + 0.4 * fastest * dt);
    CHECK((outcome.final[1].position - outcome.final[0].position).norm() < 0.12 + fastest * dt + 1e-12);
}

TEST_CASE("soft: the spring is no faster than a quarter of the substeps' rate", "[stepping]")
{
    // The limit of the speed apart goes with the hertz asked for: the overlap is so small that it does not count.
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0)), ball(0.1, Vec3(0.2 - 1e-6, 0, 0))});
    const auto place = [&](double hertz) {
        Soft method = soft(dt);
        method.hertz = hertz;
        return run_discrete(scene, method, until(2 * dt)).final[1].position.x();
    };
    CHECK(place(60) == place(1e6));
    CHECK(place(30) < place(60));
}

TEST_CASE("soft: a bullet passes no thin plate, however fast", "[stepping]")
{
    std::mt19937_64 random(4);
    for (int trial = 0; trial < 200; ++trial) {
        const double distance = 0.0105 + (1 + uniform(random)) * 1e4 * dt;
        const Scene scene =
            scene_of({ball(0.01, Vec3(-distance, 0, 0), Vec3(1e4, 0, 0))}, {plate(Vec3::UnitX(), 0, 0.001)});
        const Outcome outcome = run_discrete(scene, soft(dt), until(6 * dt));
        REQUIRE(outcome.final[0].position.x() < -0.0104);
        REQUIRE(outcome.final[0].velocity.x() == Approx(-1e4));
    }
}

TEST_CASE("soft: contacts are looked for once a step, whatever the substeps", "[stepping]")
{
    const Scene scene = tower(3, 0.5);
    CHECK(run_discrete(scene, soft(dt, 1), until(1)).counts.pair_tests ==
          run_discrete(scene, soft(dt, 8), until(1)).counts.pair_tests);
}

TEST_CASE("soft: closings that gravity makes in a step do not rebound", "[stepping]")
{
    Scene scene = tower(1, 1);
    const double slow = 0.9 * 9.81 * dt;
    scene.spheres[0].velocity.z() = -slow;
    CHECK(run_discrete(scene, soft(dt), until(dt)).final[0].velocity.z() == Approx(0).margin(1e-12));
    scene.spheres[0].velocity.z() = -slow / 0.8;
    CHECK(run_discrete(scene, soft(dt), until(dt)).final[0].velocity.z() == Approx(slow / 0.8));
}

TEST_CASE("soft: a run that is stopped within a step has reported what its substeps gave", "[stepping]")
{
    RunOptions options = until(1);
    options.max_events = 6;  // one step and a half
    const Outcome outcome = run_discrete(tower(1, 0), soft(dt), options);
    CHECK(outcome.plane_impulses[0] == Approx(9.81 * 1.5 * dt).epsilon(0.01));
}

TEST_CASE("soft: a spring without frequency and a negative damping are refused", "[stepping]")
{
    for (const auto& [hertz, damping, word] :
         {std::tuple{0.0, 1.0, "hertz must be > 0"}, std::tuple{30.0, -1.0, "damping ratio must be >= 0"}}) {
        Soft method = soft(dt);
        method.hertz = hertz;
        method.damping_ratio = damping;
        const Outcome outcome = run_discrete(tower(1, 0), method, until(1));
        CHECK(outcome.status == Status::unresolved);
        CHECK(outcome.message.find(word) != std::string::npos);
    }
}
