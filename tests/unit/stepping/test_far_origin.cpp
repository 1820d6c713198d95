#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

Scene drop_at(const Vec3& origin)
{
    Scene scene = scene_of({ball(0.1, {0.3, 0, 1.1}, {0.2, 0, 0})}, {wall(Vec3::UnitZ(), 0)}, {0, 0, -9.81});
    scene.origin = origin;
    return scene;
}

}  // namespace

TEST_CASE("discrete methods work in absolute coordinates: a far origin costs them digits, a near one none",
          "[stepping]")
{
    for (const Method& method : all_serious(steps(1e-3))) {
        CAPTURE(name(method));
        const Vec3 home = run_discrete(drop_at(Vec3::Zero()), method, until(1)).final[0].position;
        const Vec3 near = run_discrete(drop_at({1, -2, 4}), method, until(1)).final[0].position;
        const Vec3 far = run_discrete(drop_at(Vec3::Constant(1e9)), method, until(1)).final[0].position;
        CHECK((near - home).norm() < 1e-12);
        CHECK((far - home).norm() > 1e-9);  // a rounding there is 1.2e-7, a step 2e-4
        CHECK((far - home).norm() < 1e-2);
    }
}

TEST_CASE("what discrete methods report is relative to the origin, walls and samples included", "[stepping]")
{
    const Scene scene = drop_at({0, 0, 1024});
    for (const Method& method : all_serious(steps(1.0 / 1024))) {
        CAPTURE(name(method));
        std::vector<Vec3> seen;
        Observer observer;
        observer.sample_times = {0, 0.25 + 1.0 / 2048};
        observer.on_sample = [&](std::size_t, double, std::span<const BodyState> s) { seen.push_back(s[0].position); };
        const Outcome outcome = run_discrete(scene, method, until(0.6), observer);
        REQUIRE(seen.size() == 2);
        CHECK(seen[0].z() == Approx(1.1).margin(1e-12));
        CHECK(seen[1].z() == Approx(1.1 - 9.81 / 2 * 0.0627).margin(5e-3));
        CHECK(outcome.counts.impacts == 1);  // it found the floor at 1024, not at 0
        CHECK(outcome.final[0].position.z() > 0.1);
        CHECK(outcome.final[0].position.z() < 1.1);
    }
}
