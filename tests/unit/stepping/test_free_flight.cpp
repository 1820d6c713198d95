#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

TEST_CASE("Free fall is semi-implicit Euler in closed form", "[stepping]")
{
    // v_n = v0 + n h g, p_n = p0 + n h v0 + h^2 g n (n+1) / 2.
    const Vec3 p0(1, 2, 30), v0(0.5, -1, 4), g(0.3, 0, -9.81);
    const Scene scene = scene_of({ball(0.1, p0, v0)}, {wall(Vec3::UnitZ(), 0)}, g);
    for (const int substeps : {1, 5}) {
        for (const Method& method : all_discrete(steps(0.01, substeps))) {
            CAPTURE(name(method), substeps);
            const Outcome outcome = run_discrete(scene, method, until(0.5));
            const double n = 50.0 * substeps, h = 0.01 / substeps;
            REQUIRE(outcome.status == Status::reached_end);
            CHECK(outcome.counts.steps == 50 * substeps);
            CHECK(outcome.counts.impacts == 0);
            CHECK((outcome.final[0].velocity - (v0 + n * h * g)).norm() < 1e-13);
            CHECK((outcome.final[0].position - (p0 + n * h * v0 + h * h * n * (n + 1) / 2 * g)).norm() < 1e-12);
            CHECK(outcome.final[0].mode == Mode::flying);
        }
    }
}

TEST_CASE("Before the first impact of a bouncing ball the error is of first order in dt", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    const double t = 0.4, exact = 1.1 - 9.81 * t * t / 2;
    const auto error = [&](Method method) {
        return std::abs(run_discrete(scene, method, until(t)).final[0].position.z() - exact);
    };
    const auto coarse = all_discrete(steps(0.01)), fine = all_discrete(steps(0.005)),
               split = all_discrete(steps(0.01, 2));
    for (std::size_t m = 0; m < coarse.size(); ++m) {
        CAPTURE(name(coarse[m]));
        CHECK(error(coarse[m]) == Approx(9.81 * t * 0.01 / 2).epsilon(1e-9));
        CHECK(error(coarse[m]) / error(fine[m]) == Approx(2).epsilon(1e-9));
        CHECK(error(split[m]) == Approx(error(fine[m])).epsilon(1e-9));
    }
}

TEST_CASE("A run ends exactly at until, whatever dt is", "[stepping]")
{
    const Scene scene = scene_of({ball(0.1, Vec3(0, 0, 0), Vec3(2, 0, 0))});
    for (const double dt : {0.3, 0.1, 1.0 / 60, 7.0}) {
        for (const Method& method : all_discrete(steps(dt, 3))) {
            CAPTURE(name(method), dt);
            const Outcome outcome = run_discrete(scene, method, until(1));
            CHECK(outcome.time == 1);
            CHECK(static_cast<double>(outcome.counts.steps) == 3 * std::ceil(1 / dt - 1e-9));
            CHECK(outcome.final[0].position.x() == Approx(2).epsilon(1e-14));
        }
    }
    CHECK(run_discrete(scene, Naive{steps(0.25)}, RunOptions{}).time == scene.end_time);
    CHECK(run_discrete(scene, Naive{steps(0.25)}, until(0)).counts.steps == 0);
}
