#include "support/scenes.hpp"

#include <carom/study.hpp>

#include <catch2/catch.hpp>

#include <algorithm>

using namespace carom;
using namespace carom::test;
using Catch::Matchers::Contains;

namespace {

/// A ball at 1 hits two equal ones at once that rest beside each other, 60 degrees apart as it sees them: Bernoulli's
/// problem.
Scene three_balls(double gap)
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-1 - std::sqrt(0.75), 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0.5, 0});
    add_sphere(scene, 0.5, {gap, -0.5, 0});
    return scene;
}

Comparison compared(const Scene& scene)
{
    CompareOptions options;
    options.methods = {"event"};
    options.until = scene.end_time;
    options.repeats = 1;
    return compare_methods(scene, options);
}

}  // namespace

TEST_CASE("where several contacts are one instant the verdict names it and what each operator gives", "[conventions]")
{
    const Comparison c = compared(three_balls(0));
    REQUIRE(c.reference.conventions.size() == 1);
    const Convention& met = c.reference.conventions.front();
    CHECK(met.time == Approx(1));
    CHECK(met.differ);
    REQUIRE(met.bodies.size() == 3);
    // By hand: pushed at once along both normals, 30 degrees from its way, the first ball has (1 - 3/2 . 4/5) of its
    // speed; hit one after the other, the second takes cos^2 30 of it first.
    const auto first_after = [&](ImpactOperator by) {
        for (const Convention::Answer& answer : met.answers)
            if (answer.impact_operator == by) return answer.velocities.front();
        return Vec3(Vec3::Constant(7));
    };
    CHECK((first_after(ImpactOperator::reflections) - Vec3(-0.2, 0, 0)).norm() < 1e-12);
    CHECK((first_after(ImpactOperator::lcp) - Vec3(-0.2, 0, 0)).norm() < 1e-12);
    CHECK(first_after(ImpactOperator::sequential).y() != Approx(0).margin(1e-3));
    const auto told = std::find_if(c.verdict.begin(), c.verdict.end(), [](const std::string& sentence) {
        return sentence.find("is a convention") != std::string::npos;
    });
    REQUIRE(told != c.verdict.end());
    CHECK_THAT(*told, Contains("s0, s1, s2"));
    for (const char* each : {"reflections (-0.2, 0, 0)", "sequential (", "lcp (-0.2, 0, 0)", "the scene's"})
        CHECK_THAT(*told, Contains(each));
}

TEST_CASE("impacts that come one after the other are no convention", "[conventions]")
{
    const Comparison c = compared(three_balls(1e-3));
    CHECK(c.reference.conventions.empty());
    for (const std::string& sentence : c.verdict) CHECK_THAT(sentence, !Contains("convention"));
}
