#include "exactly.hpp"

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double tiny = 1e-22;

Scene chain_of_three(double restitution = 1)
{
    Scene scene = row({1, 0, 0}, restitution);
    scene.spheres[0].position.x() = -1;  // hits at t = 1
    return scene;
}

Scene bernoulli()
{
    Scene scene;
    scene.spheres = {ball("cue", {-2, 0, 0}, {1, 0, 0}, 1, 0.5), ball("up", {0, 0.5, 0}, {0, 0, 0}, 1, 0.5),
                     ball("down", {0, -0.5, 0}, {0, 0, 0}, 1, 0.5)};
    return scene;
}

}  // namespace

TEST_CASE("The operator lcp lets no ball of a chain break away, sequential does", "[reference]")
{
    Scene scene = chain_of_three();
    for (const LcpLaw law : {LcpLaw::newton, LcpLaw::poisson}) {
        scene.impact.impact_operator = ImpactOperator::lcp;
        scene.impact.lcp.law = law;
        const Exact run = exactly(scene, 2);
        REQUIRE(run.reason() == "");
        CHECK(off(run.flight(0).velocity(2), along_x(-Real(1) / 3)) < tiny);
        CHECK(off(run.flight(1).velocity(2), along_x(Real(2) / 3)) < tiny);
        CHECK(off(run.flight(2).velocity(2), along_x(Real(2) / 3)) < tiny);
    }
    scene.impact.impact_operator = ImpactOperator::sequential;
    const Exact run = exactly(scene, 2);
    for (BodyId i = 0; i < 3; ++i) CHECK(off(run.flight(i).velocity(2), along_x(i == 2 ? 1 : 0)) < tiny);
}

TEST_CASE("Compression and expansion of a chain give back e of each impulse", "[reference]")
{
    // Compression: all at 1/3, impulses 2/3 and 1/3.
    Scene scene = chain_of_three(0.5);
    scene.impact.impact_operator = ImpactOperator::lcp;
    scene.impact.lcp.law = LcpLaw::poisson;
    const Exact run = exactly(scene, 2);
    CHECK(off(run.flight(0).velocity(2), along_x(0)) < tiny);
    CHECK(off(run.flight(1).velocity(2), along_x(Real(1) / 2)) < tiny);
    CHECK(off(run.flight(2).velocity(2), along_x(Real(1) / 2)) < tiny);
}

TEST_CASE("Sequential takes contacts in the order of ids", "[reference]")
{
    Scene scene = bernoulli();
    scene.impact.impact_operator = ImpactOperator::sequential;
    const Real s = sqrt(Real(3)) / 8;
    const Exact run = exactly(scene, 4);  // two thirds of the speed along each line of centres, one after the other
    CHECK(off(run.flight(0).velocity(4), {-Real(1) / 8, -s, 0}) < tiny);
    CHECK(off(run.flight(1).velocity(4), {Real(3) / 4, 2 * s, 0}) < tiny);
    CHECK(off(run.flight(2).velocity(4), {Real(3) / 8, -s, 0}) < tiny);
    std::swap(scene.spheres[1], scene.spheres[2]);
    const Exact other = exactly(scene, 4);
    CHECK(off(other.flight(0).velocity(4), {-Real(1) / 8, s, 0}) < tiny);
}

TEST_CASE("Where sequential does not end its answer is the inelastic one", "[reference]")
{
    Scene scene;  // pinched between two planes that face each other
    scene.impact.impact_operator = ImpactOperator::sequential;
    scene.spheres = {ball("ball", {0, 0, 0}, {1, -1, 0}, 1, 0.5)};
    scene.planes = {plane("left", {1, 0, 0}, -0.5), plane("right", {-1, 0, 0}, -0.5)};
    CHECK(off(exactly(scene, 1).flight(0).velocity(1), {0, -1, 0}) < tiny);
}

TEST_CASE("An instant whose outcome is a convention is told, with what each operator gives", "[reference]")
{
    const std::vector<double> times{2};
    const Reference chain = make_reference(chain_of_three(), 2, times);
    REQUIRE(chain.conventions.size() == 1);
    const ReferenceConvention& what = chain.conventions[0];
    CHECK(what.time == 1);
    CHECK(what.bodies == std::vector<BodyId>{0, 1, 2});
    CHECK(what.differ);
    REQUIRE(what.answers.size() == 3);
    CHECK(what.answers[0].impact_operator == ImpactOperator::reflections);
    CHECK((what.answers[0].velocities[2] - Vec3(1, 0, 0)).norm() < 1e-15);
    CHECK(what.answers[1].impact_operator == ImpactOperator::sequential);
    CHECK((what.answers[1].velocities[2] - Vec3(1, 0, 0)).norm() < 1e-15);
    CHECK(what.answers[2].impact_operator == ImpactOperator::lcp);
    CHECK((what.answers[2].velocities[2] - Vec3(2.0 / 3, 0, 0)).norm() < 1e-15);
    CHECK((chain.samples[0][2].velocity - Vec3(1, 0, 0)).norm() < 1e-15);  // it goes on with that of the scene

    CHECK(make_reference(bernoulli(), 4, times).conventions.at(0).differ);
}

TEST_CASE("No convention decides where operators agree, or where one contact is alone", "[reference]")
{
    Scene scene;  // slides on a floor into a wall
    scene.gravity = {0, 0, -8};
    scene.spheres = {ball("ball", {0, 0, 0.5}, {1, 0.25, 0}, 1, 0.5)};
    scene.planes = {plane("floor", {0, 0, 1}, 0), plane("wall", {-1, 0, 0}, -1.5)};
    const std::vector<double> times{1.5};
    const Reference square = make_reference(scene, 1.5, times);
    REQUIRE(square.conventions.size() == 1);
    CHECK_FALSE(square.conventions[0].differ);
    scene.planes[1] = plane("overhang", {-0.8, 0, -0.6}, -1.2);
    const Reference corner = make_reference(scene, 1.5, times);
    REQUIRE(!corner.conventions.empty());
    CHECK(corner.conventions[0].differ);

    Scene two = row({1, 0});
    two.spheres[0].position.x() = -1;
    CHECK(make_reference(two, 3, times).conventions.empty());
}
