#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace carom;
using namespace carom::test;

namespace {

/// dv/dt = g - k v in closed form, with the functions of the C library in long double.
struct Viscous {
    Vec3 p, v, g;
    double k;

    long double s(double t) const { return -std::expm1(-static_cast<long double>(k) * t) / k; }
    long double q(double t) const
    {
        const long double x = static_cast<long double>(k) * t;
        if (x > 0.01L) return (t - s(t)) / k;
        return (1 - x / 3 * (1 - x / 4 * (1 - x / 5 * (1 - x / 6 * (1 - x / 7))))) * t * t / 2;
    }
    Vec3 place(double t) const { return p + static_cast<double>(s(t)) * v + static_cast<double>(q(t)) * g; }
    Vec3 velocity(double t) const { return v + static_cast<double>(s(t)) * (g - k * v); }
};

StepOptions parabola(double dt, int substeps = 1)
{
    StepOptions options = steps(dt, substeps);
    options.integrator = Integrator::parabola;
    return options;
}

Scene viscous(std::vector<Sphere> spheres, std::vector<Plane> planes, const Vec3& gravity, double drag)
{
    Scene scene = scene_of(std::move(spheres), std::move(planes), gravity);
    scene.drag = drag;
    return scene;
}

const Vec3 g(0.3, 0, -9.81);
const Viscous thrown{Vec3(1, 2, 30), Vec3(0.5, -1, 4), g, 0.7};

/// The first time up to `end` at which a function falls through 0, as so many samples show it, to rounding; infinity if
/// none does.
double first_fall(const std::function<double(double)>& gap, double end, int samples)
{
    double before = 0;
    for (int i = 1; i <= samples; ++i) {
        double low = before, high = before = end * i / samples;
        if (!(gap(low) > 0 && gap(high) <= 0)) continue;
        for (int k = 0; k < 60; ++k) {
            const double middle = (low + high) / 2;
            (gap(middle) > 0 ? low : high) = middle;
        }
        return high;
    }
    return std::numeric_limits<double>::infinity();
}

}  // namespace

TEST_CASE("With drag euler is the recursion v <- (1 - h k) v + h g, in closed form", "[stepping]")
{
    const Scene scene = viscous({ball(0.1, thrown.p, thrown.v)}, {}, g, thrown.k);
    for (const int substeps : {1, 5}) {
        for (const Method& method : all_discrete(steps(0.02, substeps))) {
            CAPTURE(name(method), substeps);
            const Outcome outcome = run_discrete(scene, method, until(1));
            const double h = 0.02 / substeps, n = 50 * substeps, left = std::pow(1 - h * thrown.k, n);
            const Vec3 fastest = g / thrown.k, rest = thrown.v - fastest;
            CHECK((outcome.final[0].velocity - (fastest + left * rest)).norm() < 1e-12);
            const Vec3 way = n * h * fastest + ((1 - h * thrown.k) * (1 - left) / thrown.k) * rest;
            CHECK((outcome.final[0].position - (thrown.p + way)).norm() < 1e-11);
        }
    }
}

TEST_CASE("With drag the error of euler is of first order", "[stepping]")
{
    const Scene scene = viscous({ball(0.1, thrown.p, thrown.v)}, {}, g, thrown.k);
    const auto error = [&](double dt) {
        const Outcome outcome = run_discrete(scene, PositionBased{steps(dt)}, until(1));
        return (outcome.final[0].position - thrown.place(1)).norm();
    };
    for (const double dt : {1.0 / 50, 1.0 / 100, 1.0 / 200}) {
        CHECK(error(dt) > 1e-3);
        CHECK(error(dt) / error(dt / 2) == Approx(2).epsilon(0.01));
    }
}

TEST_CASE("With parabola free flight under drag is exact, whatever step and drag are", "[stepping]")
{
    for (const double k : {1e-12, 1e-3, 0.7, 40.0}) {
        Viscous exact = thrown;
        exact.k = k;
        const Scene scene = viscous({ball(0.1, exact.p, exact.v)}, {}, g, k);
        for (const double dt : {0.7, 1.0 / 60, 1.0 / 1000}) {
            for (const Method& method : all_discrete(parabola(dt, 2))) {
                CAPTURE(name(method), dt, k);
                const Outcome outcome = run_discrete(scene, method, until(0.7));
                CHECK((outcome.final[0].velocity - exact.velocity(0.7)).norm() < 1e-12);  // of 1400 sums
                CHECK((outcome.final[0].position - exact.place(0.7)).norm() < 1e-11);
            }
        }
    }
}

TEST_CASE("A falling ball comes to the terminal velocity g / k", "[stepping]")
{
    const Scene scene = viscous({ball(0.1, Vec3(0, 0, 0))}, {}, Vec3(0, 0, -9.81), 2);
    for (const StepOptions& options : {steps(0.01), parabola(0.01), parabola(3)})
        for (const Method& method : all_discrete(options)) {
            CAPTURE(name(method), options.dt);
            const Outcome outcome = run_discrete(scene, method, until(30));
            CHECK(outcome.final[0].velocity.z() == Approx(-4.905).epsilon(1e-13));
        }
}

TEST_CASE("A sample inside a step is on the damped flight of parabola, and on the line of euler", "[stepping]")
{
    const Scene scene = viscous({ball(0.1, thrown.p, thrown.v)}, {}, g, thrown.k);
    for (const bool bent : {true, false})
        for (const Method& method : all_discrete(bent ? parabola(0.5) : steps(0.5))) {
            CAPTURE(name(method), bent);
            Observer observer;
            observer.sample_times = {0, 0.125, 0.5};
            std::vector<BodyState> seen;
            observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
                seen.push_back(states[0]);
            };
            run_discrete(scene, method, until(0.5), observer);
            REQUIRE(seen.size() == 3);
            const double part = 0.25;
            const Vec3 place =
                bent ? thrown.place(0.125) : Vec3(seen[0].position + part * (seen[2].position - seen[0].position));
            const Vec3 velocity =
                bent ? thrown.velocity(0.125) : Vec3(seen[0].velocity + part * (seen[2].velocity - seen[0].velocity));
            CHECK((seen[1].position - place).norm() < 1e-13);
            CHECK((seen[1].velocity - velocity).norm() < 1e-13);
        }
}

TEST_CASE("With parabola a ball that lies on the floor stays there under drag", "[stepping]")
{
    Scene scene = viscous({ball(0.125, Vec3(0, 0, 0.125))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81), 3);
    scene.materials[0].restitution = 0.5;
    for (const Method& method : {Method(VelocityBased{parabola(1.0 / 60)}), Method(Moreau{parabola(1.0 / 60)}),
                                 Method(ImpactSubsteps{parabola(1.0 / 60)}), Method(Bisection{parabola(1.0 / 60)})}) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(2));
        CHECK(outcome.final[0].position.z() == Approx(0.125).epsilon(1e-15));
        CHECK(outcome.final[0].velocity.norm() < 1e-14);
    }
}

TEST_CASE("With parabola a ball slides down an incline under drag as the closed form has it", "[stepping]")
{
    const double angle = 0.5, t = 1.5, height = 0.1 - 1e-13, k = 0.8;
    const Vec3 n(std::sin(angle), 0, std::cos(angle)), down(std::cos(angle), 0, -std::sin(angle));
    const Scene scene = viscous({ball(0.1, height * n)}, {wall(n, 0)}, Vec3(0, 0, -9.81), k);
    const Viscous slide{height * n, Vec3::Zero(), 9.81 * std::sin(angle) * down, k};
    for (const Method& method : {Method(VelocityBased{parabola(1.0 / 60)}), Method(Moreau{parabola(1.0 / 60)}),
                                 Method(ImpactSubsteps{parabola(1.0 / 60)})}) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(t));
        CHECK((outcome.final[0].position - slide.place(t)).norm() < 1e-12);
        CHECK((outcome.final[0].velocity - slide.velocity(t)).norm() < 1e-12);
    }
}

TEST_CASE("A spring carries a ball at rest under drag as without it", "[stepping]")
{
    // k x = m g: drag has no say where nothing moves.
    const Scene scene =
        viscous({ball(0.1, Vec3(0, 0, 0.1 - 9.81 / 5000))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81), 5);
    for (const Integrator integrator : {Integrator::euler, Integrator::parabola}) {
        Penalty method{steps(1.0 / 1000)};
        method.integrator = integrator;
        method.stiffness = 5000;
        const Outcome outcome = run_discrete(scene, method, until(1));
        CHECK(outcome.final[0].position.z() == Approx(0.1 - 9.81 / 5000).epsilon(1e-12));
        CHECK(outcome.final[0].velocity.norm() < 1e-12);
    }
}

TEST_CASE("With parabola toi and bisection bounce under drag when the closed form does", "[stepping]")
{
    const double e = 0.8, k = 0.9, t = 3;
    Scene scene =
        viscous({ball(0.1, Vec3(0, 0, 1.1), Vec3(0.4, 0, 0))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81), k);
    scene.materials[0].restitution = e;
    std::vector<double> times;
    Viscous flight{Vec3(0, 0, 1.1), Vec3(0.4, 0, 0), Vec3(0, 0, -9.81), k};
    double now = 0;
    while (times.size() < 6) {
        // Late enough that the rebound is no root.
        const double begin = times.empty() ? 0 : 1e-3;
        const double fall = first_fall([&](double at) { return flight.place(begin + at).z() - 0.1; }, t, 3000) + begin;
        now += fall;
        times.push_back(now);
        Vec3 v = flight.velocity(fall);
        v.z() *= -e;
        flight.p = flight.place(fall);
        flight.v = v;
    }
    REQUIRE(now < t);
    for (const Method& method : {Method(ImpactSubsteps{parabola(1.0 / 60)}), Method(Bisection{parabola(1.0 / 60)}),
                                 Method(ImpactSubsteps{parabola(0.75)})}) {
        CAPTURE(name(method));
        std::vector<double> seen;
        Observer observer;
        observer.on_event = [&](const Event& event) { seen.push_back(event.time); };
        run_discrete(scene, method, until(t), observer);
        REQUIRE(seen.size() >= times.size());
        for (std::size_t i = 0; i < times.size(); ++i) CHECK(seen[i] == Approx(times[i]).margin(1e-12));
    }
}

TEST_CASE("toi meets a fixed ball under drag when sampling does, however long its step is", "[stepping]")
{
    std::mt19937_64 random(17);
    int met = 0, turned = 0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 place = uniform_vector(random, -3, 3), aim = uniform_vector(random, -3, 3);
        const Vec3 field = uniform_vector(random, -6, 6);
        const Viscous flight{place, aim - place, field, std::exp(4 * uniform(random) - 2)};
        if (flight.p.norm() < 1.1) continue;
        Sphere fixed = ball(0.5, Vec3::Zero());
        fixed.fixed = true;
        const Scene scene = viscous({fixed, ball(0.5, flight.p, flight.v)}, {}, flight.g, flight.k);
        const double end = 3;
        const auto gap = [&](double t) { return flight.place(t).norm() - 1; };
        const double expected = first_fall(gap, end, 5000);
        double seen = std::numeric_limits<double>::infinity();
        Observer observer;
        observer.on_event = [&](const Event& event) { seen = std::min(seen, event.time); };
        run_discrete(scene, ImpactSubsteps{parabola(end)}, until(end), observer);
        CAPTURE(i, flight.k, expected, seen);
        if (std::isfinite(expected)) {
            ++met;
            turned += gap(end) > 0;
            CHECK(seen == Approx(expected).margin(1e-12));
        } else {
            CHECK((!std::isfinite(seen) || std::abs(gap(seen)) < 1e-12));  // a touch between two samples
        }
    }
    CHECK(met > 30);
    CHECK(turned > 5);
}

TEST_CASE("euler is refused where it is not stable under drag, and the message says what to take", "[stepping]")
{
    const Scene scene = viscous({ball(0.1, thrown.p, thrown.v)}, {}, g, 4);
    for (const Method& method : all_discrete(steps(0.5))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(1));
        CHECK(outcome.status == Status::unresolved);
        CHECK(outcome.message.find("0.5") != std::string::npos);
        CHECK(outcome.message.find("parabola") != std::string::npos);
    }
    for (const StepOptions& options : {steps(0.49), steps(0.5, 2), parabola(0.5)})
        for (const Method& method : all_discrete(options))
            CHECK(run_discrete(scene, method, until(1)).status == Status::reached_end);
}
