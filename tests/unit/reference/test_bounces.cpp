#include "exactly.hpp"

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

/// A ball of radius 0.1 above a fixed ball of radius 1.
Scene above_a_globe(double gap, double restitution, const Vec3& v = Vec3::Zero())
{
    Scene scene;
    scene.gravity = {0, 0, -9.81};
    scene.materials[0].restitution = restitution;
    scene.spheres = {ball("globe", {0, 0, 0}, {0, 0, 0}, 1, 1), ball("ball", {0, 0, 1.1 + gap}, v, 1, 0.1)};
    scene.spheres[0].fixed = true;
    return scene;
}

}  // namespace

TEST_CASE("A ball on a fixed ball bounces to the end of its geometric series, however slow", "[reference]")
{
    for (const double e : {0.5, 0.9, 0.97}) {
        const Scene scene = above_a_globe(1e-5, e);
        const Real h = Real(scene.spheres[1].position.z()) - Real(1.0) - Real(0.1);
        const Real rest = sqrt(2 * h / Real(9.81)) * (1 + Real(e)) / (1 - Real(e));
        const Exact run = exactly(scene, 1);
        REQUIRE(run.reason() == "");
        CHECK(run.mode(1, 1) == Mode::resting);
        CHECK(abs(run.flight(1).t - rest) < 1e-26);
        // It is listed as one impact and a series; the contact persists from its end on.
        CHECK(run.record.impacts.size() == 1);
        REQUIRE(run.record.series.size() == 1);
        CHECK(run.record.series[0].body == 1);
        CHECK(run.record.series[0].plane == 0);
        CHECK(run.record.series[0].end == static_cast<double>(rest));
        REQUIRE(run.record.since.count({0, 1}) == 1);
        CHECK(run.record.since.at({0, 1}) == run.flight(1).t);
    }
    const std::vector<double> times{0.0271, 0.02714, 1};
    const Reference reference = make_reference(above_a_globe(1e-5, 0.9), 1, times);
    CHECK(reference.samples[0][1].mode == Mode::series);
    CHECK(reference.samples[1][1].mode == Mode::resting);
    REQUIRE(reference.contacts.size() == 1);
    CHECK(reference.contacts[0].begin == Approx(std::sqrt(2e-5 / 9.81) * 19).epsilon(1e-11));
    CHECK(reference.contacts[0].end == 1);
}

TEST_CASE("Bounces beside the top of a sphere end in a slide down its side", "[reference]")
{
    const Scene scene = above_a_globe(1e-5, 0.5, {0.05, 0, 0});
    const Exact run = exactly(scene, 0.5);
    REQUIRE(run.reason() == "");
    CHECK(run.mode(1, 0.5) == Mode::sliding);
    REQUIRE(run.record.since.size() == 1);
    // Normal and tangential motion hardly know of each other before: to leading order the series is that of a plane.
    const double begin = static_cast<double>(run.record.since.at({0, 1}));
    CHECK(begin == Approx(std::sqrt(2e-5 / 9.81) * 3).epsilon(1e-2));
    // Then energy is kept: v^2/2 + g z.
    const auto energy = [&](double t) {
        const ExactVector v = run.flight(1).velocity(t);
        return Real(dot(v, v) / 2 + Real(9.81) * run.flight(1).position(t).z);
    };
    const Exact early = exactly(scene, begin + 1e-6);
    const ExactVector v = early.flight(1).velocity(begin + 1e-6);
    const Real before = dot(v, v) / 2 + Real(9.81) * early.flight(1).position(begin + 1e-6).z;
    CHECK(abs(energy(0.5) - before) < 1e-20);
}

TEST_CASE("No option of rest and guard changes anything", "[reference]")
{
    Scene scene = gas(2, 0.3, {0, 0, -9.81});
    scene.materials[0].restitution = 0.5;
    const std::vector<double> times{0.1, 0.2};
    const Reference plain = make_reference(scene, 0.2, times);
    REQUIRE(plain.samples.size() == 2);
    scene.rest.closing_speed = 1;
    scene.rest.window = 1;
    scene.rest.numeric_step = 1e-3;
    scene.rest.gap_tolerance = 1e-3;
    scene.rest.series_below = 1;
    scene.guard.impacts = 1;
    scene.guard.window = 1;
    for (const RestPolicy policy : {RestPolicy::contact, RestPolicy::micro, RestPolicy::none}) {
        scene.rest.policy = policy;
        const Reference other = make_reference(scene, 0.2, times);
        REQUIRE(other.samples.size() == 2);
        CHECK(other.impacts.size() == plain.impacts.size());
        CHECK(other.series.size() == plain.series.size());
        for (std::size_t i = 0; i < scene.spheres.size(); ++i)
            CHECK(other.samples[1][i].position == plain.samples[1][i].position);
    }
}

TEST_CASE("Two balls that drop on a floor together come to rest one on the other", "[reference]")
{
    Scene scene = drop(0.01, 0.5);
    scene.spheres.push_back(ball("on top", {0, 0, 0.43}, {0, 0, 0}, 1, 0.125));
    const Exact run = exactly(scene, 2);
    REQUIRE(run.reason() == "");
    for (BodyId i = 0; i < 2; ++i) {
        CHECK(run.mode(i, 2) == Mode::resting);
        CHECK(off(run.flight(i).position(2), {0, 0, Real(0.125) + i * Real(0.25)}) < 1e-25);
    }
    // Each of the contacts persists from the end of its bounces on, the lower one first and for the last time at last.
    CHECK(run.record.since.size() == 2);
    CHECK(run.record.since.at({0, 1}) >= run.record.since.at({0, 2}));
}

TEST_CASE("Infinitely many bounces with friction stop what slides along, whatever it bounces on", "[reference]")
{
    Scene scene = above_a_globe(1e-5, 0.5, {1e-3, 0, 0});
    ContactRule rule;
    rule.restitution = 0.5;
    rule.tangential = 1 - 1e-9;
    scene.contacts = {rule};
    const Exact run = exactly(scene, 0.006);
    REQUIRE(run.record.since.size() == 1);
    const Real begin = run.record.since.at({0, 1});
    REQUIRE(begin < 0.006);
    // At rest there, it begins to slide with the acceleration of the slope.
    const ExactVector v = run.flight(1).velocity(0.006), x = run.flight(1).position(begin);
    CHECK(static_cast<double>(v.x) ==
          Approx(static_cast<double>(Real(9.81) * x.x / Real(1.1) * (Real(0.006) - begin))).epsilon(1e-4));
}
