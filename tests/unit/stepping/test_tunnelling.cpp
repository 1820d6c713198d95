#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double radius = 0.01, thickness = 0.001;
constexpr double window = radius + thickness / 2;

/// A bullet at distance `distance` before a plate across x.
Scene bullet(double speed, double distance)
{
    return scene_of({ball(radius, Vec3(-distance, 0, 0), Vec3(speed, 0, 0))}, {plate(Vec3::UnitX(), 0, thickness)});
}

/// Share of 1000 random phases at which the plate is missed.
double share_missed(const Method& method, double speed, double dt)
{
    std::mt19937_64 random(20240607);
    int missed = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const double distance = window + (1 + uniform(random)) * speed * dt;
        const Outcome outcome = run_discrete(bullet(speed, distance), method, until(6 * dt));
        missed += outcome.final[0].position.x() > 0;
    }
    return missed / 1000.0;
}

}  // namespace

TEST_CASE("At 1e4 m/s a step of 1/60 s misses a plate of 1 mm but for those that look ahead, a step of 5e-7 s finds it",
          "[stepping]")
{
    for (const Method& method : all_serious(steps(1.0 / 60))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(bullet(1e4, 0.1), method, until(1.0 / 60));
        const bool is_found = looks_ahead(method);
        CHECK(outcome.counts.impacts == (is_found ? 1 : 0));
        CHECK((outcome.final[0].position.x() > 160) == !is_found);
    }
    for (const Method& method : all_impulsive(steps(5e-7))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(bullet(1e4, 0.1), method, until(1e-4));
        CHECK(outcome.counts.impacts == 1);
        CHECK(outcome.final[0].position.x() < -0.5);
    }
}

TEST_CASE("pbd and velocity miss a plate at random phases as often as max(0, 1 - (r + thickness/2) / (v dt))",
          "[stepping]")
{
    const double dt = 1.0 / 60, critical = window / dt;
    for (const Method& method : {Method(VelocityBased{steps(dt)}), Method(PositionBased{steps(dt)})}) {
        for (const double factor : {0.4, 0.8, 1.5, 4.0}) {
            CAPTURE(name(method), factor);
            const double expected = std::max(0.0, 1 - 1 / factor);
            const double sigma = std::sqrt(expected * (1 - expected) / 1000);
            CHECK(std::abs(share_missed(method, factor * critical, dt) - expected) <= 3 * sigma);
        }
    }
}

TEST_CASE("Bisection looks at both sides of a plate and misses max(0, 1 - 2 (r + thickness/2) / (v dt))", "[stepping]")
{
    // From the far side it goes back and finds the near one: its window is twice as wide.
    const double dt = 1.0 / 60, critical = window / dt;
    for (const double factor : {0.8, 1.5, 4.0}) {
        CAPTURE(factor);
        const double expected = std::max(0.0, 1 - 2 / factor);
        const double sigma = std::sqrt(expected * (1 - expected) / 1000);
        CHECK(std::abs(share_missed(Bisection{steps(dt)}, factor * critical, dt) - expected) <= 3 * sigma);
    }
}

TEST_CASE("A sphere that crosses the middle of a plate between two steps is pushed out on the far side", "[stepping]")
{
    // Nothing remembers sides: pbd takes the side on which the centre is when it looks.
    const double speed = 2 * window / 0.01;
    const Outcome outcome = run_discrete(bullet(speed, 1.5 * window), PositionBased{steps(0.01)}, until(0.01));
    CHECK(outcome.final[0].position.x() == Approx(window));
    CHECK(outcome.final[0].velocity.x() == Approx(speed));
}
