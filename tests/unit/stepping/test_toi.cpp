#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

ImpactSubsteps toi(double dt, Integrator integrator = Integrator::parabola)
{
    ImpactSubsteps method{steps(dt)};
    method.integrator = integrator;
    return method;
}

std::vector<Event> events_of(const Scene& scene, const Method& method, double end)
{
    std::vector<Event> events;
    Observer observer;
    observer.on_event = [&](const Event& e) { events.push_back(e); };
    run_discrete(scene, method, until(end), observer);
    return events;
}

Scene bouncing_ball(double e)
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1), Vec3(0.5, 0, 0))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    scene.materials[0].restitution = e;
    return scene;
}

/// Height and velocity of a ball dropped from 1 above its rest, bounce after bounce in closed form.
struct Drop {
    double height, velocity;
};

Drop bouncing_ball_at(double t, double e)
{
    constexpr double g = 9.81;
    const double first = std::sqrt(2 / g);
    if (t < first) return {1 - g * t * t / 2, -g * t};
    double begin = first, up = e * g * first;
    for (int bounce = 0; bounce < 400; ++bounce) {
        const double flight = 2 * up / g;
        if (t < begin + flight) {
            const double s = t - begin;
            return {up * s - g * s * s / 2, up - g * s};
        }
        begin += flight;
        up *= e;
    }
    return {0, 0};
}

double worst_against_closed_form(double e, const ImpactSubsteps& method)
{
    double worst = 0;
    Observer observer;
    observer.sample_times = sample_grid(5, 1237);
    observer.on_sample = [&](std::size_t, double time, std::span<const BodyState> states) {
        const Vec3 exact(0.5 * time, 0, 0.1 + bouncing_ball_at(time, e).height);
        worst = std::max(worst, (states[0].position - exact).norm());
    };
    run_discrete(bouncing_ball(e), method, until(5), observer);
    return worst;
}

}  // namespace

TEST_CASE("With parabolas toi follows a bouncing ball to its rest and in it, to rounding", "[stepping]")
{
    // At rest after 4.06 at e = 0.8; at 0.5 after 1.35. Samples fall inside steps.
    for (const double dt : {1.0 / 60, 1.0 / 7, 1.0 / 240}) {
        CAPTURE(dt);
        CHECK(worst_against_closed_form(0.8, toi(dt)) < 1e-12);
        CHECK(worst_against_closed_form(0.5, toi(dt)) < 1e-12);
        CHECK(worst_against_closed_form(1, toi(dt)) < 1e-12);
    }
    const Outcome outcome = run_discrete(bouncing_ball(0.8), toi(1.0 / 60), until(5));
    CHECK(outcome.final[0].velocity.z() == 0);
    CHECK(outcome.final[0].velocity.x() == 0.5);
    CHECK(outcome.max_penetration < 1e-15);
    CHECK(outcome.counts.impacts < 100);  // rest by rounding, not by the most that a substep may have
}

TEST_CASE("Control: with few impacts a substep, or with euler, toi is not exact", "[stepping]")
{
    ImpactSubsteps few = toi(1.0 / 60);
    few.most_impacts = 2;
    CHECK(worst_against_closed_form(0.8, few) > 1e-6);
    CHECK(worst_against_closed_form(0.8, toi(1.0 / 60, Integrator::euler)) > 1e-3);
}

TEST_CASE("Two balls dropped above each other are exact under toi with parabolas", "[stepping]")
{
    // Elastic, masses 3 and 1: the lower bounces, meets the upper in flight; one dimension in closed form.
    const double g = 9.81, r = 0.1;
    const Scene scene = scene_of({ball(r, Vec3(0, 0, 1.1), Vec3::Zero(), 3), ball(r, Vec3(0, 0, 1.5), Vec3::Zero(), 1)},
                                 {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -g));
    // The lower hits the floor at t1; the gap of 0.2 to the upper closes at their constant relative speed.
    const double t1 = std::sqrt(2 / g), v = g * t1, t2 = t1 + 0.2 / (2 * v);
    const double lower = v - g * (t2 - t1), upper = -g * t2;
    const double mean = (3 * lower + upper) / 4, lower_after = 2 * mean - lower, upper_after = 2 * mean - upper;
    const double z2 = r + v * (t2 - t1) - g * (t2 - t1) * (t2 - t1) / 2, t = 0.1;
    const Outcome outcome = run_discrete(scene, toi(1.0 / 60), until(t2 + t));
    REQUIRE(outcome.counts.impacts == 2);
    CHECK(std::abs(outcome.final[0].position.z() - (z2 + lower_after * t - g * t * t / 2)) < 1e-12);
    CHECK(std::abs(outcome.final[1].position.z() - (z2 + 2 * r + upper_after * t - g * t * t / 2)) < 1e-12);
    CHECK(std::abs(outcome.final[1].velocity.z() - (upper_after - g * t)) < 1e-12);
}

TEST_CASE("toi does not tunnel, however fast and thin", "[stepping]")
{
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola}) {
        for (const double speed : {1.0, 1e3, 1e6}) {
            CAPTURE(speed, name(integrator));
            Scene thin =
                scene_of({ball(0.01, Vec3(-0.503, 0.001, 0), Vec3(speed, 0, 0))}, {plate(Vec3::UnitX(), 0, 1e-4)});
            const Outcome at_plate = run_discrete(thin, toi(1.0 / 60, integrator), until(1));
            CHECK(at_plate.counts.impacts == 1);
            CHECK(at_plate.final[0].position.x() < 0);
            thin.planes.clear();
            thin.spheres.push_back(ball(0.01, Vec3(0, 0.015, 0)));
            thin.spheres[1].id = "target";
            const Outcome at_sphere = run_discrete(thin, toi(1.0 / 60, integrator), until(1));
            CHECK(at_sphere.counts.impacts == 1);
        }
    }
}

TEST_CASE("A ball thrown over a fixed one and caught by gravity is hit where the quartic says", "[stepping]")
{
    // Unlike accelerations. Straight up beside it and down on it: two roots of the path lie in one step.
    Sphere held = ball(0.1, Vec3(0, 0, 0));
    held.fixed = true;
    const Scene scene = scene_of({held, ball(0.1, Vec3(-0.3, 0, 0.1), Vec3(0.5, 0, 2))}, {}, Vec3(0, 0, -9.81));
    const auto gap = [](double t) { return std::hypot(-0.3 + 0.5 * t, 0.1 + 2 * t - 9.81 * t * t / 2) - 0.2; };
    double exact = 0;  // scan, then halve: the first contact
    while (gap(exact) > 0) exact += 1e-6;
    double lo = exact - 1e-6, hi = exact;
    for (int k = 0; k < 60; ++k) (gap(lo + (hi - lo) / 2) > 0 ? lo : hi) = lo + (hi - lo) / 2;
    for (const double dt : {1.0, 1.0 / 60}) {
        const auto events = events_of(scene, toi(dt), 1);
        REQUIRE(!events.empty());
        CHECK(events[0].time == Approx(lo).epsilon(1e-12));
    }
}

TEST_CASE("Under toi what lies stays, one on the other, and planes feel the weight", "[stepping]")
{
    Scene scene = scene_of({}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    for (int k = 0; k < 5; ++k) scene.spheres.push_back(ball(0.125, Vec3(0, 0, 0.125 + 0.25 * k)));
    for (const double e : {0.0, 0.5, 0.9}) {
        scene.materials[0].restitution = e;
        const Outcome outcome = run_discrete(scene, toi(1.0 / 60), until(2));
        CAPTURE(e);
        CHECK(outcome.counts.impacts == 0);
        for (std::size_t k = 0; k < 5; ++k)
            CHECK((outcome.final[k].position - scene.spheres[k].position).norm() < 1e-9);
        CHECK(outcome.plane_impulses[0] == Approx(5 * 9.81 * 2).epsilon(0.02));
    }
}

TEST_CASE("A heap in which bounces accumulate keeps every sphere in the box under toi", "[stepping]")
{
    Scene scene = gas(100, 0.1, 1.3, 4);
    scene.gravity = Vec3(0, 0, -9.81);
    scene.materials[0].restitution = 0.3;
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola}) {
        const Outcome outcome = run_discrete(scene, toi(1.0 / 240, integrator), until(1));
        CAPTURE(name(integrator), outcome.counts.impacts);
        CHECK(outcome.status == Status::reached_end);
        CHECK(outcome.max_penetration < 0.05);
        for (const BodyState& state : outcome.final) {
            CHECK(state.position.minCoeff() > 0.08);
            CHECK(state.velocity.norm() < 1);
        }
    }
}

TEST_CASE("An elastic gas under toi keeps its energy and never overlaps, found by all pairs and by the grid",
          "[stepping]")
{
    for (const std::size_t n : {20U, 300U}) {
        const Scene scene = gas(n, 0.1, n == 20 ? 1 : 2.2, 9);
        const auto energy = [](const auto& spheres) {
            double sum = 0;
            for (const auto& s : spheres) sum += s.velocity.squaredNorm();
            return sum;
        };
        const Outcome outcome = run_discrete(scene, toi(1.0 / 30), until(2));
        CAPTURE(n);
        CHECK(outcome.counts.impacts > static_cast<std::int64_t>(3 * n));
        CHECK(energy(outcome.final) == Approx(energy(scene.spheres)).epsilon(1e-12));
        CHECK(outcome.max_penetration < 1e-13);
    }
}

TEST_CASE("toi refuses less than one impact a substep", "[stepping]")
{
    ImpactSubsteps none = toi(0.1);
    none.most_impacts = 0;
    const Outcome outcome = run_discrete(bouncing_ball(0.5), none, until(1));
    CHECK(outcome.status == Status::unresolved);
    CHECK(outcome.message.find("most_impacts") != std::string::npos);
}
