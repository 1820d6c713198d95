#include "run_all.hpp"
#include "small_scenes.hpp"
#include "stepping/contact_spring.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double pi = std::numbers::pi;
const Vec3 earth(0, 0, -9.81);

Penalty penalty(double dt, Integrator integrator = Integrator::euler)
{
    Penalty method{steps(dt)};
    method.integrator = integrator;
    return method;
}

/// A ball of mass 2 and radius 0.1 that meets a wall after `time` at speed 3.
Scene thrown_at_wall(double restitution, double time)
{
    Scene scene = scene_of({ball(0.1, Vec3(0.1 + 3 * time, 0, 0), Vec3(-3, 0, 0), 2)}, {wall(Vec3::UnitX(), 0)});
    scene.materials[0].restitution = restitution;
    return scene;
}

/// Largest |x| over the last of 4000 steps of v += h (-w^2 x - 2 z w v), x += h v, from x = 1, v = 0, or beyond 1e6.
double last_swing(double frequency, double damping, double h)
{
    double x = 1, v = 0, largest = 0;
    for (int k = 0; k < 4000 && largest < 1e6; ++k) {
        v += h * (-frequency * frequency * x - 2 * damping * frequency * v);
        x += h * v;
        if (k >= 3900 || std::abs(x) > 1e6) largest = std::max(largest, std::abs(x));
    }
    return largest;
}

}  // namespace

TEST_CASE("The damping ratio of a restitution is that of a half swing which keeps this share of the speed",
          "[stepping]")
{
    for (const double e : {1e-3, 0.1, 0.5, 0.9, 1.0}) {
        const double zeta = stepping::damping_ratio(e);
        CHECK(std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta)) == Approx(e));
    }
    CHECK(stepping::damping_ratio(0) == 1);
}

TEST_CASE("Springs swing ever higher in steps longer than the stable one, and do not in shorter ones", "[stepping]")
{
    CHECK(stepping::stable_step(50, 0) == Approx(2 / 50.0));
    for (const double zeta : {0.01, 0.2, 0.7, 1.0}) {
        const double longest = stepping::stable_step(50, zeta);
        CAPTURE(zeta);
        CHECK(last_swing(50, zeta, 0.99 * longest) < 1);
        CHECK(last_swing(50, zeta, 1.01 * longest) > 1e3);
    }
}

TEST_CASE("penalty: a ball leaves a wall when and as fast as a damped oscillator does, and is as deep in it",
          "[stepping]")
{
    const double k = 2e4, mass = 2, speed = 3, omega = std::sqrt(k / mass);
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola})
        for (const double e : {1.0, 0.8, 0.3}) {
            const double zeta = stepping::damping_ratio(e), swing = std::sqrt(1 - zeta * zeta);
            const double duration = pi / (omega * swing), h = duration / 2000, meet = 0.01;
            Penalty method = penalty(h, integrator);
            method.stiffness = k;
            CAPTURE(e, static_cast<int>(integrator));
            const Outcome outcome = run_discrete(thrown_at_wall(e, meet), method, until(meet + 2 * duration));
            CHECK(outcome.counts.impacts == 1);
            CHECK(outcome.final[0].velocity.x() == Approx(e * speed).epsilon(0.01));
            // Gone for a duration at that speed: the end of the contact is right within four steps.
            CHECK(outcome.final[0].position.x() - 0.1 == Approx(e * speed * duration).margin(4 * h * speed));
            const double deepest = speed / omega * std::exp(-zeta / swing * std::atan2(swing, zeta));
            CHECK(outcome.max_penetration == Approx(deepest).epsilon(0.01));
            CHECK(outcome.plane_impulses[0] == Approx(mass * (outcome.final[0].velocity.x() + speed)).epsilon(1e-12));
        }
}

TEST_CASE("penalty: two bodies of any masses stay in contact for ten substeps unless a stiffness is given",
          "[stepping]")
{
    for (const double mass : {1e-3, 1.0, 1e6})
        for (const int substeps : {1, 3}) {
            Penalty method = penalty(0.003);
            method.substeps = substeps;
            const double h = 0.003 / substeps;
            const Scene scene = scene_of(
                {ball(0.5, Vec3(-0.55, 0, 0), Vec3(1, 0, 0)), ball(0.5, Vec3(0.55, 0, 0), Vec3::Zero(), mass)});
            Observer observer;
            observer.sample_times = {};
            const int most = 60 * substeps;
            for (int k = 0; k <= most; ++k) observer.sample_times.push_back(std::min(k * h, 0.18));
            int touching = 0;
            observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) {
                touching += (s[1].position - s[0].position).norm() < 1 ? 1 : 0;
            };
            run_discrete(scene, method, until(0.18), observer);
            CAPTURE(mass, substeps);
            CHECK(touching >= 9);
            CHECK(touching <= 11);
        }
}

TEST_CASE("penalty: a ball rests as deep in the floor as its weight presses the spring", "[stepping]")
{
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola}) {
        Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0.15), Vec3::Zero(), 3)}, {wall(Vec3::UnitZ(), 0)}, earth);
        scene.materials[0].restitution = 0.5;
        Penalty method = penalty(1e-3, integrator);
        method.stiffness = 1e4;
        const Outcome outcome = run_discrete(scene, method, until(5));
        CHECK(outcome.final[0].position.z() == Approx(0.1 - 3 * 9.81 / 1e4).epsilon(1e-9));
        CHECK(outcome.final[0].velocity.norm() < 1e-9);
        CHECK(outcome.plane_impulses[0] == Approx(3 * 9.81 * 5).epsilon(1e-6));
    }
}

TEST_CASE("penalty: an elastic ball keeps its height to a hundredth", "[stepping]")
{
    // The phase of the step in which the floor is first seen is worth 0.4 % of the energy at ten steps a contact.
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, earth);
    double peak = 0;
    Observer observer;
    observer.sample_times = sample_grid(1.4, 1400);
    observer.on_sample = [&](std::size_t, double time, std::span<const BodyState> s) {
        if (time > 0.6) peak = std::max(peak, s[0].position.z());
    };
    run_discrete(scene, penalty(1e-3, Integrator::parabola), until(1.4), observer);
    CHECK(peak == Approx(1.1).epsilon(0.01));
}

TEST_CASE("penalty: a step beyond the stable one of the stiffness is refused with its cure", "[stepping]")
{
    Scene scene = thrown_at_wall(0.5, 0.1);
    scene.spheres.push_back(ball(0.1, Vec3(5, 0, 0), Vec3::Zero(), 0.5));  // the lighter one is the stiffer one
    const double k = 1e4, longest = stepping::stable_step(std::sqrt(k / 0.5), stepping::damping_ratio(0.5));
    const auto run = [&](double dt, int substeps) {
        Penalty method = penalty(dt);
        method.stiffness = k;
        method.substeps = substeps;
        return run_discrete(scene, method, until(0.5));
    };
    CHECK(run(0.999 * longest, 1).status == Status::reached_end);
    CHECK(run(2.997 * longest, 3).status == Status::reached_end);
    const Outcome refused = run(1.001 * longest, 1);
    CHECK(refused.status == Status::unresolved);
    CHECK(refused.counts.steps == 0);
    CHECK(refused.message.find("stable step of a stiffness of 10000") != std::string::npos);
    CHECK(refused.message.find("take dt <= 0.0") != std::string::npos);
    // The cures are cures.
    const auto number_after = [&](const std::string& words) {
        return std::stod(refused.message.substr(refused.message.find(words) + words.size()));
    };
    CHECK(number_after("take dt <= ") == Approx(longest));
    CHECK(number_after("a stiffness <= ") == Approx(k / (1.001 * 1.001)));
    // Without contacts that could be there is nothing to refuse.
    scene.planes.clear();
    scene.spheres.pop_back();
    CHECK(run(1, 1).status == Status::reached_end);
    for (const double wrong : {0.0, -1.0, std::nan("")}) {
        Penalty method = penalty(0.01);
        method.stiffness = wrong;
        const Outcome outcome = run_discrete(scene, method, until(0.1));
        CHECK(outcome.status == Status::unresolved);
        CHECK(outcome.message.find("stiffness must be > 0") != std::string::npos);
    }
}

TEST_CASE("penalty: who is deeper than the middle of a plate comes out behind it, where a look for overlaps sees it",
          "[stepping]")
{
    const double h = 5e-7;  // 5 mm of way a step, and a contact is 16 mm deep
    const Scene scene = scene_of({ball(0.01, Vec3(-0.1, 0, 0), Vec3(1e4, 0, 0))}, {plate(Vec3::UnitX(), 0, 0.001)});
    CHECK(run_discrete(scene, penalty(h), until(1e-4)).final[0].position.x() > 0.5);
    CHECK(run_discrete(scene, VelocityBased{steps(h)}, until(1e-4)).final[0].position.x() < -0.5);
    CHECK(run_discrete(scene, penalty(h / 4), until(1e-4)).final[0].position.x() < -0.5);
}

TEST_CASE("penalty: tangential factors act once a contact, when it begins", "[stepping]")
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0.5), Vec3(2, 0, 0))}, {wall(Vec3::UnitZ(), 0)}, earth);
    scene.materials[0] = Material{"felt", 0, 0.5, ""};
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola})
        CHECK(run_discrete(scene, penalty(1e-3, integrator), until(2)).final[0].velocity.x() ==
              Approx(1).epsilon(1e-12));
}
