#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

const Vec3 g{0, 0, -9.81};

Sphere fixed_ball(double radius, const Vec3& position)
{
    Sphere s = ball(radius, position);
    s.fixed = true;
    return s;
}

/// A ball 1 m above the top of a fixed one.
Scene drop_on_fixed()
{
    return scene_of({fixed_ball(0.5, {0, 0, 0}), ball(0.5, {0, 0, 2})}, {}, g);
}

}  // namespace

TEST_CASE("a fixed sphere never moves, whatever hits it", "[stepping]")
{
    Scene scene = drop_on_fixed();
    scene.spheres.push_back(ball(0.3, {-2, 0, 0}, {9, 0, 0}, 1e6));
    for (const Method& method : all_discrete(steps(1e-3, 2, 2))) {
        CAPTURE(name(method));
        std::size_t seen = 0;
        Observer observer;
        observer.sample_times = sample_grid(1, 20);
        observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
            seen += states[0].position == Vec3::Zero() && states[0].velocity == Vec3::Zero() &&
                            states[0].mode == Mode::fixed && states[1].mode == Mode::flying
                        ? 1
                        : 0;
        };
        const Outcome outcome = run_discrete(scene, method, until(1), observer);
        CHECK(seen == 21);
        CHECK(outcome.final[0].position == Vec3::Zero());
        CHECK(outcome.final[0].mode == Mode::fixed);
        CHECK(outcome.counts.impacts >= 2);
    }
}

TEST_CASE("a fixed sphere is infinitely heavy: an elastic ball comes back as fast as it came", "[stepping]")
{
    const double impact = std::sqrt(2 / 9.81);
    for (const double mass : {1e-6, 1.0, 1e6})
        for (const Method& method : all_impulsive(steps(1e-4))) {
            CAPTURE(name(method), mass);
            Scene scene = drop_on_fixed();
            scene.spheres[0].mass = mass;  // of no meaning
            const Outcome outcome = run_discrete(scene, method, until(2 * impact));
            CHECK(outcome.counts.impacts == 1);
            CHECK(outcome.final[1].position.z() == Approx(2).margin(2e-3));
            CHECK(outcome.final[1].velocity.z() == Approx(0).margin(5e-3));
        }
}

TEST_CASE("pbd moves the free one of a pair by all of the overlap, a free pair by half each", "[stepping]")
{
    for (const bool weighted : {false, true}) {
        PositionBased method{steps(1e-3)};
        method.mass_weighted = weighted;
        for (const bool first : {false, true}) {
            Scene scene = scene_of({ball(0.5, {0, 0, 0}), ball(0.5, {0.9, 0, 0})});
            scene.spheres[first ? 0 : 1].fixed = true;
            const Outcome outcome = run_discrete(scene, method, until(1e-3));
            CHECK(outcome.final[first ? 1 : 0].position.x() == Approx(first ? 1.0 : -0.1).margin(1e-15));
            CHECK(outcome.final[first ? 0 : 1].position == scene.spheres[first ? 0 : 1].position);
        }
        const Outcome free =
            run_discrete(scene_of({ball(0.5, {0, 0, 0}), ball(0.5, {0.9, 0, 0})}), method, until(1e-3));
        CHECK(free.final[0].position.x() == Approx(-0.05));
        CHECK(free.final[1].position.x() == Approx(0.95));
    }
}

TEST_CASE("fixed spheres in each other and in a wall are nobody's business", "[stepping]")
{
    const Scene scene =
        scene_of({fixed_ball(0.5, {0, 0, 0}), fixed_ball(0.5, {0.2, 0, 0}), fixed_ball(0.5, {0, 0, 0.1})},
                 {wall(Vec3::UnitZ(), 0)}, g);
    for (const Method& method : all_discrete(steps(0.01, 1, 2))) {
        CAPTURE(name(method));
        const Outcome outcome = run_discrete(scene, method, until(0.1));
        CHECK(outcome.status == Status::reached_end);
        CHECK(outcome.counts.impacts == 0);
        CHECK(outcome.max_penetration == 0);
        CHECK(outcome.final[2].position == scene.spheres[2].position);
    }
}
