#include "exactly.hpp"

#include <cmath>

using namespace carom;
using namespace carom::test;

namespace {

constexpr double tiny = 1e-25;

Scene bernoulli(double restitution)
{
    Scene scene;
    scene.materials[0].restitution = restitution;
    scene.spheres = {ball("cue", {-2, 0, 0}, {1, 0, 0}, 1, 0.5), ball("up", {0, 0.5, 0}, {0, 0, 0}, 1, 0.5),
                     ball("down", {0, -0.5, 0}, {0, 0, 0}, 1, 0.5)};
    return scene;
}

/// Rows of 1 .. 5 behind each other, the cue in front of the first.
Scene rack()
{
    Scene scene;
    scene.spheres = {ball("cue", {-3, 0, 0}, {1, 0, 0}, 1, 0.5)};
    for (int line = 0; line < 5; ++line)
        for (int k = 0; k <= line; ++k)
            scene.spheres.push_back(ball("ball-" + std::to_string(scene.spheres.size()),
                                         {line * 0.8660254037844386, k - line / 2.0, 0}, {0, 0, 0}, 1, 0.5));
    return scene;
}

Real kinetic_energy(const Scene& scene, const Exact& run, double t)
{
    Real sum = 0;
    for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
        const ExactVector v = run.flight(static_cast<BodyId>(i)).velocity(t);
        sum += scene.spheres[i].mass * dot(v, v) / 2;
    }
    return sum;
}

}  // namespace

TEST_CASE("In a cradle of five as many balls leave as come in", "[reference]")
{
    for (int k = 1; k <= 4; ++k) {
        CAPTURE(k);
        Scene scene = row({0, 0, 0, 0, 0});
        for (int i = 0; i < k; ++i) {
            scene.spheres[static_cast<std::size_t>(i)].position.x() -= 1;
            scene.spheres[static_cast<std::size_t>(i)].velocity.x() = 2;
        }
        const Exact run = exactly(scene, 1);
        REQUIRE_FALSE(run.stopped());
        for (int i = 0; i < 5; ++i) CHECK(off(run.flight(i).velocity(1), along_x(i < 5 - k ? 0 : 2)) < tiny);
        CHECK(run.record.impacts.size() == 4);
        for (const ReferenceImpact& impact : run.record.impacts) CHECK(impact.time == 0.5);
    }
}

TEST_CASE("A ball that hits a chain of masses 2 and 1 at once gives -1/3, 2/9, 8/9", "[reference]")
{
    Scene scene = row({1, 0, 0});
    scene.spheres[0].position.x() = -2;
    scene.spheres[1].mass = 2;
    const Exact run = exactly(scene, 2);
    CHECK(off(run.flight(0).velocity(2), along_x(-Real(1) / 3)) < tiny);
    CHECK(off(run.flight(1).velocity(2), along_x(Real(2) / 9)) < tiny);
    CHECK(off(run.flight(2).velocity(2), along_x(Real(8) / 9)) < tiny);
}

TEST_CASE("Three in a row that close from both sides rebound with e", "[reference]")
{
    for (const double e : {1.0, 0.5, 0.0}) {
        const Exact run = exactly(row({1, 0, -1}, e), 1);
        CHECK(off(run.flight(0).velocity(1), along_x(-e)) < tiny);
        CHECK(off(run.flight(1).velocity(1), along_x(0)) < tiny);
        CHECK(off(run.flight(2).velocity(1), along_x(e)) < tiny);
    }
}

TEST_CASE("Bernoulli's problem", "[reference]")
{
    const Exact elastic = exactly(bernoulli(1), 4);
    const Real root = sqrt(Real(3)) / 5;
    CHECK(off(elastic.flight(0).velocity(4), along_x(-Real(1) / 5)) < tiny);
    CHECK(off(elastic.flight(1).velocity(4), {Real(3) / 5, root, 0}) < tiny);
    CHECK(off(elastic.flight(2).velocity(4), {Real(3) / 5, -root, 0}) < tiny);
    const Exact inelastic = exactly(bernoulli(0), 4);
    CHECK(off(inelastic.flight(0).velocity(4), along_x(Real(2) / 5)) < tiny);
    CHECK(off(inelastic.flight(1).velocity(4), {Real(3) / 10, root / 2, 0}) < tiny);
    CHECK(static_cast<double>(kinetic_energy(bernoulli(0), inelastic, 4)) == Approx(0.2).epsilon(1e-15));
}

TEST_CASE("A rack of fifteen is broken symmetrically, with its momentum and energy", "[reference]")
{
    const Scene scene = rack();
    const Exact run = exactly(scene, 2.5);
    REQUIRE_FALSE(run.stopped());
    ExactVector momentum;
    for (BodyId i = 0; i < 16; ++i) momentum = momentum + run.flight(i).velocity(2.5);
    CHECK(off(momentum, along_x(1)) < tiny);
    CHECK(abs(kinetic_energy(scene, run, 2.5) - Real(0.5)) < tiny);
    for (int line = 0, first = 1; line < 5; first += ++line)
        for (int k = 0; k <= line; ++k) {
            const ExactVector v = run.flight(first + k).velocity(2.5), w = run.flight(first + line - k).velocity(2.5);
            CHECK(off(v, {w.x, -w.y, w.z}) < tiny);
        }
    CHECK(off(run.flight(0).velocity(2.5), along_x(0)) > 0.1);
    CHECK(off(run.flight(15).velocity(2.5), along_x(0)) > 0.1);
}

TEST_CASE("A ball in a corner of two or three orthogonal planes turns back", "[reference]")
{
    Scene scene;
    scene.spheres = {ball("ball", {2, 2, 2}, {-1, -1, -1}, 1, 0.5)};
    scene.planes = {plane("left", {1, 0, 0}, 0), plane("below", {0, 1, 0}, 0)};
    CHECK(off(exactly(scene, 3).flight(0).velocity(3), {1, 1, -1}) < tiny);
    scene.planes.push_back(plane("behind", {0, 0, 1}, 0));
    const Exact run = exactly(scene, 3);
    CHECK(off(run.flight(0).velocity(3), {1, 1, 1}) < tiny);
    CHECK(run.record.impacts.size() == 3);
}

TEST_CASE("In a corner tangential factors share: they stop what slides along, and give no energy", "[reference]")
{
    Scene scene;
    scene.materials[0].tangential = 0.5;
    scene.spheres = {ball("ball", {2, 2, 0}, {-1, -1, 4}, 1, 0.5)};
    scene.planes = {plane("left", {1, 0, 0}, 0), plane("below", {0, 1, 0}, 0)};
    // After the rebound (1, 1, 4): each plane takes half of a half of what is along it.
    CHECK(off(exactly(scene, 3).flight(0).velocity(3), {Real(0.75), Real(0.75), 2}) < tiny);
}

TEST_CASE("A wedge too narrow to leave stops what flies into it", "[reference]")
{
    // Two planes face each other: jammed. Along them the velocity stays.
    Scene scene;
    scene.spheres = {ball("ball", {0, 0, 0}, {1, -1, 0}, 1, 0.5)};
    scene.planes = {plane("left", {1, 0, 0}, -0.5), plane("right", {-1, 0, 0}, -0.5)};
    const Exact run = exactly(scene, 1);
    REQUIRE_FALSE(run.stopped());
    CHECK(off(run.flight(0).velocity(1), {0, -1, 0}) < tiny);
}

TEST_CASE("Of two balls that drop together the light one on top takes all the energy", "[reference]")
{
    Scene scene;
    scene.spheres = {ball("low", {0, 0, 1.5}, {0, 0, -1}, 3, 0.5), ball("high", {0, 0, 2.5}, {0, 0, -1}, 1, 0.5)};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    const Exact run = exactly(scene, 2);
    CHECK(off(run.flight(0).velocity(2), {0, 0, 0}) < tiny);
    CHECK(off(run.flight(1).velocity(2), {0, 0, 2}) < tiny);
}

TEST_CASE("A ball that falls on a resting one twice as heavy: 4/9 and 7/9 of its speed, upwards", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -8};
    scene.spheres = {ball("resting", {0, 0, 0.5}, {0, 0, 0}, 2, 0.5), ball("falling", {0, 0, 2.5}, {0, 0, 0}, 1, 0.5)};
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    const double contact = 0.5;  // at speed 4
    const Exact run = exactly(scene, contact);
    REQUIRE_FALSE(run.stopped());
    CHECK(run.record.impacts.size() == 2);
    CHECK(off(run.flight(0).velocity(contact), {0, 0, Real(16) / 9}) < tiny);
    CHECK(off(run.flight(1).velocity(contact), {0, 0, Real(28) / 9}) < tiny);
}

TEST_CASE("A ball that falls on a resting tower of five leaves it standing", "[reference]")
{
    Scene scene;
    scene.gravity = {0, 0, -8};
    for (int i = 0; i < 6; ++i)
        scene.spheres.push_back(ball("b" + std::to_string(i), {0, 0, i + 0.5}, {0, 0, 0}, 1, 0.5));
    scene.spheres[5].position.z() += 1;
    scene.planes = {plane("floor", {0, 0, 1}, 0)};
    const Exact run = exactly(scene, 0.75);
    REQUIRE_FALSE(run.stopped());
    CHECK(run.record.impacts.size() == 6);
    for (BodyId i = 0; i < 5; ++i) {
        CHECK(off(run.flight(i).velocity(0.75), {0, 0, 0}) < tiny);
        CHECK(run.mode(i, 0.75) == Mode::resting);
    }
    CHECK(off(run.flight(5).velocity(0.5), {0, 0, 4}) < tiny);
    CHECK(run.mode(5, 0.75) == Mode::flying);
}

TEST_CASE("In a pile-up without restitution all go on with the mean velocity, in contact", "[reference]")
{
    Scene scene = row({1, 0, 0, 0, 0}, 0);
    const Exact run = exactly(scene, 3);
    REQUIRE_FALSE(run.stopped());
    for (BodyId i = 0; i < 5; ++i) CHECK(off(run.flight(i).velocity(3), along_x(Real(1) / 5)) < tiny);
    CHECK(abs(kinetic_energy(scene, run, 3) - Real(1) / 10) < tiny);
}

TEST_CASE("Three in a row collapse below e = 7 - 4 sqrt(3), and part above it", "[reference]")
{
    // Two like balls meet one at rest between them, the left one first.
    for (const double e : {0.071, 0.073}) {
        Scene scene = row({1, 0, -1}, e);
        scene.spheres[0].position.x() = -1;
        const Exact run = exactly(scene, 9);
        REQUIRE(run.reason() == "");
        const Real left = run.flight(1).velocity(9).x - run.flight(0).velocity(9).x,
                   right = run.flight(2).velocity(9).x - run.flight(1).velocity(9).x;
        CAPTURE(e, left, right);
        CHECK((left == 0 && right == 0) == (e < 7 - 4 * std::sqrt(3.0)));
        CHECK(left >= 0);
        CHECK(right >= 0);
    }
}

TEST_CASE("A row collapses into one body where restitution is small", "[reference]")
{
    Scene scene = row({1, 0, -1}, 0.05);
    scene.spheres[0].position.x() = -1;
    scene.spheres[2].position.x() = 3.5;
    const Exact run = exactly(scene, 9);
    CHECK(run.reason() == "");
    for (BodyId i = 0; i < 3; ++i) CHECK(off(run.flight(i).velocity(9), along_x(0)) < 1e-6);
    CHECK(off(run.flight(0).velocity(9), run.flight(2).velocity(9)) < tiny);
    CHECK(run.record.impacts.size() > 4);
}

TEST_CASE("Energy is lost as the blend says where contacts of different restitution close", "[reference]")
{
    // Two like balls meet one between them; lambda |c| is the same on both sides: e is the mean.
    Scene scene = row({1, 0, -1});
    scene.materials = {Material{"soft", 0, 1, ""}, Material{"hard", 1, 1, ""}};
    scene.spheres[1].material = scene.spheres[2].material = 1;
    const Exact run = exactly(scene, 1);
    CHECK(off(run.flight(0).velocity(1), along_x(-Real(1) / 2)) < tiny);
    CHECK(off(run.flight(2).velocity(1), along_x(Real(1) / 2)) < tiny);
}

TEST_CASE("What the reference leaves to others ends it with bodies and time", "[reference]")
{
    Scene scene = row({1, 0, 0});
    scene.spheres[0].position.x() = -1;
    SECTION("another impact operator")
    {
        scene.impact.impact_operator = ImpactOperator::shock;
        CHECK(exactly(scene, 3).reason() ==
              "several contacts at one instant, for the impact operator shock or jacobi: ball-0, ball-1, ball-2 at t = "
              "1");
    }
    SECTION("attenuation in a cluster")
    {
        ContactRule rule;
        rule.attenuation = 0.5;
        scene.contacts = {rule};
        CHECK(exactly(scene, 3).reason().find("several contacts at one instant, with attenuation") == 0);
    }
    SECTION("bounces that take too long to fade")
    {
        scene = row({1, 0}, 0.999);  // between walls hardly wider than the two
        scene.planes = {plane("left", {1, 0, 0}, -0.5), plane("right", {-1, 0, 0}, -1.501)};
        Patience endless;
        Exact run(scene, 30, endless, 1000);
        run.advance(30);
        CHECK(run.reason().find("more work than 250000 impacts") == 0);
        CHECK(run.stopped_at() > 0.01);
        CHECK(run.record.impacts.size() > 500);
    }
}
