#include "run_all.hpp"
#include "small_scenes.hpp"
#include "stepping/bracket.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

std::vector<Event> events_of(const Scene& scene, const Method& method, double end)
{
    std::vector<Event> events;
    Observer observer;
    observer.on_event = [&](const Event& e) { events.push_back(e); };
    run_discrete(scene, method, until(end), observer);
    return events;
}

}  // namespace

TEST_CASE("A bracket is bisected to neighbouring doubles", "[stepping]")
{
    std::int64_t evaluations = 0;
    const stepping::Bracket root = stepping::bisect(
        0, 1, [](double t) { return t * t >= 0.5; }, evaluations);
    CHECK(root.before * root.before < 0.5);
    CHECK(root.after * root.after >= 0.5);
    CHECK(std::nextafter(root.before, 1) == root.after);
    CHECK(evaluations > 50);
    CHECK(evaluations <= 64);
    const stepping::Bracket tiny = stepping::bisect(
        0, 1, [](double t) { return t > 0; }, evaluations);
    CHECK(tiny.before == 0);
    CHECK(tiny.after > 0);
}

TEST_CASE("Without gravity bisection has the time of contact to rounding, whatever dt is", "[stepping]")
{
    // Grazing pair: contact when |p| = 0.2 at offset 0.19, x = -sqrt(0.2^2 - 0.19^2).
    const Scene scene = scene_of({ball(0.1, Vec3(-1, 0.19, 0), Vec3(2, 0, 0)), ball(0.1, Vec3(0, 0, 0))});
    const double exact = (1 - std::sqrt(0.2 * 0.2 - 0.19 * 0.19)) / 2;
    for (const double dt : {0.05, 0.01, 0.003}) {
        const auto events = events_of(scene, Bisection{steps(dt)}, 1);
        REQUIRE(events.size() == 1);
        CHECK(events[0].time == Approx(exact).epsilon(1e-13));
        CHECK((events[0].normal - Vec3(-std::sqrt(0.04 - 0.0361), 0.19, 0) / 0.2).norm() < 1e-13);
    }
}

TEST_CASE("Under gravity the time of the first bounce converges to the exact one at first order", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    const double exact = std::sqrt(2 / 9.81);
    double before = 0;
    for (const double dt : {4e-3, 2e-3, 1e-3, 5e-4}) {
        const auto events = events_of(scene, Bisection{steps(dt)}, 0.6);
        REQUIRE(events.size() == 1);
        const double error = std::abs(events[0].time - exact);
        CHECK(error < dt);
        if (before > 0) CHECK(before / error == Approx(2).epsilon(0.02));
        before = error;
    }
}

TEST_CASE("Bisection resolves several bounces within one step", "[stepping]")
{
    // A ball in a slot with 0.1 of play at speed 1: one bounce every 0.1, nine in 0.95; the step is 1.
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 0.15), Vec3(0, 0, 1))}, {wall(Vec3::UnitZ(), 0), wall(-Vec3::UnitZ(), -0.3)});
    const auto events = events_of(scene, Bisection{steps(1)}, 1);
    REQUIRE(events.size() == 10);
    for (std::size_t k = 0; k < events.size(); ++k)
        CHECK(events[k].time == Approx(0.05 + 0.1 * static_cast<double>(k)).epsilon(1e-12));
    const Outcome outcome = run_discrete(scene, Bisection{steps(1)}, until(1));
    CHECK(outcome.counts.root_solves == 10);
    CHECK(outcome.max_penetration < 1e-13);
}

TEST_CASE("A contact foreseen before a sphere was deflected is forgotten", "[stepping]")
{
    // On its old path ball 0 is at the wall at t = 0.6. It grazes ball 1 before, goes on slower, and at the end of the
    // step has not reached the wall: a bounce at 0.6 would happen in mid-air.
    const Scene scene = scene_of({ball(0.1, Vec3(0.7, 0, 0), Vec3(-1, 0, 0)), ball(0.1, Vec3(0.15, 0.19, 0))},
                                 {wall(Vec3::UnitX(), 0)});
    const double dx = std::sqrt(0.2 * 0.2 - 0.19 * 0.19), nx = dx / 0.2;
    const double grazed = 0.55 - dx, speed = 1 - nx * nx, end = 0.605;
    const auto events = events_of(scene, Bisection{steps(1)}, end);
    REQUIRE(events.size() == 1);
    CHECK(events[0].b == 1);
    CHECK(events[0].time == Approx(grazed).epsilon(1e-12));
    const Vec3 final = run_discrete(scene, Bisection{steps(1)}, until(end)).final[0].position;
    CHECK(final.x() == Approx(0.7 - grazed - speed * (end - grazed)).epsilon(1e-12));
    CHECK(final.x() > 0.1);
}

TEST_CASE("Bisection ends even where bounces accumulate within a step", "[stepping]")
{
    // A ball caught between two walls that are closer than its diameter, and one between walls that leave it 1e-12.
    Scene caught =
        scene_of({ball(0.1, Vec3(0, 0, 0.095), Vec3(0, 0, 1))}, {wall(Vec3::UnitZ(), 0), wall(-Vec3::UnitZ(), -0.19)});
    const Outcome stuck = run_discrete(caught, Bisection{steps(0.1)}, until(1));
    CHECK(stuck.status == Status::reached_end);
    CHECK(stuck.counts.impacts <= 10 * (100 + 10 + 2));
    CHECK(stuck.counts.impacts >= 100);
    CHECK(stuck.max_penetration >= 0.005);
    caught.spheres[0].position.z() = 0.1;
    caught.planes[1].offset = -0.2 - 1e-12;
    CHECK(run_discrete(caught, Bisection{steps(0.1)}, until(1)).counts.impacts <= 10 * (100 + 10 + 2));
}

TEST_CASE("A heap in which bounces accumulate keeps every sphere in the box under bisection", "[stepping]")
{
    // 100 spheres collapse; each substep reaches the limit of responses. None may be forgotten and fall through the
    // floor.
    Scene scene = gas(100, 0.1, 1.3, 4);
    scene.gravity = Vec3(0, 0, -9.81);
    scene.materials[0].restitution = 0.3;
    const Outcome outcome = run_discrete(scene, Bisection{steps(1.0 / 240)}, until(1));
    CHECK(outcome.counts.impacts > 100 * 1000);
    CHECK(outcome.max_penetration < 0.1);
    for (const BodyState& state : outcome.final) CHECK(state.position.minCoeff() > 0);
}

TEST_CASE("An elastic gas under bisection keeps its energy, never overlaps and stays in its box", "[stepping]")
{
    for (const std::size_t n : {20U, 300U}) {  // all pairs, and the grid
        const double side = n == 20 ? 1 : 2.2, r = 0.1;
        const Scene scene = gas(n, r, side, 9);
        double initial = 0;
        for (const Sphere& s : scene.spheres) initial += s.velocity.squaredNorm();
        double deepest = 0, drift = 0;
        Observer observer;
        observer.sample_times = sample_grid(2, 40);
        observer.on_sample = [&](std::size_t k, double time, std::span<const BodyState> states) {
            if (std::abs(time * 30 - std::round(time * 30)) > 1e-9 && k > 0) return;  // inside a step chords are cut
            double energy = 0;
            for (std::size_t i = 0; i < states.size(); ++i) {
                energy += states[i].velocity.squaredNorm();
                for (std::size_t j = 0; j < i; ++j)
                    deepest = std::max(deepest, 2 * r - (states[i].position - states[j].position).norm());
                deepest = std::max(deepest, r - states[i].position.minCoeff());
                deepest = std::max(deepest, states[i].position.maxCoeff() + r - side);
            }
            drift = std::max(drift, std::abs(energy / initial - 1));
        };
        const Outcome outcome = run_discrete(scene, Bisection{steps(1.0 / 30)}, until(2), observer);
        CAPTURE(n);
        CHECK(outcome.counts.impacts > static_cast<std::int64_t>(3 * n));
        CHECK(outcome.counts.root_solves >= outcome.counts.impacts - 5);
        CHECK(outcome.counts.root_solves < 2 * outcome.counts.impacts);
        CHECK(drift < 1e-12);
        CHECK(deepest < 1e-13);
        CHECK(outcome.max_penetration < 1e-13);
    }
}

TEST_CASE("Control: pbd of the same gas does overlap", "[stepping]")
{
    CHECK(run_discrete(gas(20, 0.1, 1, 9), PositionBased{steps(1.0 / 30)}, until(2)).max_penetration > 1e-3);
}

TEST_CASE("The work of a step of bisection grows with the number of spheres, not with its square", "[stepping]")
{
    // Steps so long that one sphere in three has a response in each: every response looks for what moved before it.
    const auto tests_for_one = [](std::size_t n) {
        const double side = std::cbrt(static_cast<double>(n)) * 0.3;
        const Outcome outcome = run_discrete(gas(n, 0.1, side, 3), Bisection{steps(0.05)}, until(0.25));
        REQUIRE(outcome.counts.impacts > static_cast<std::int64_t>(n));
        return static_cast<double>(outcome.counts.pair_tests) / static_cast<double>(n);
    };
    CHECK(tests_for_one(3200) < 1.5 * tests_for_one(400));
}
