#include "tunnel/judge.hpp"
#include "unit/tunnel/dummies.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using namespace carom::tunnel;

namespace {

const double step = 0.01;

Cell cell_of(Target target)
{
    return {target, target == Target::wall ? std::nullopt : std::optional(0.2), 0.1, step, 40};
}

/// Gap between the ball of a throw and what it meets, `time` after its begin.
double gap(const Throw& t, double time)
{
    const Sphere& ball = t.scene.spheres[0];
    const Vec3 place = ball.position + time * ball.velocity;
    if (!t.scene.planes.empty()) return plane_gap(t.scene.planes[0], ball, place);
    return (place - t.scene.spheres[1].position).norm() - ball.radius - t.scene.spheres[1].radius;
}

}  // namespace

TEST_CASE("a throw touches at its contact time, within its first step, and not before", "[tunnel]")
{
    for (const Target target : {Target::plate, Target::sphere, Target::wall}) {
        CellThrows throws(cell_of(target));
        for (const double phase : {1e-3, 0.3, 1.0})
            for (const double offset : {0.0, 0.6, 0.99}) {
                if (offset > 0 && target != Target::sphere) continue;
                const Throw& t = throws.at({phase, offset});
                CAPTURE(phase, offset, t.contact_time);
                CHECK(t.contact_time == Approx(phase * step).epsilon(1e-12));
                CHECK(std::abs(gap(t, t.contact_time)) < 1e-13);
                CHECK(gap(t, 0.999 * t.contact_time) > 0);
                CHECK(t.velocity.norm() == Approx(40).epsilon(1e-14));
                CHECK((t.velocity - Vec3(40, 0, 0)).norm() == Approx(t.speed_change).epsilon(1e-14));
            }
    }
}

TEST_CASE("a throw is told from a sphere's middle: hit at 45 degrees it goes off at a right angle", "[tunnel]")
{
    CellThrows throws(cell_of(Target::sphere));
    const Throw& t = throws.at({0.5, std::sqrt(0.5)});
    CHECK((t.velocity - Vec3(0, 0, 40)).norm() < 1e-12);
    CHECK((t.position - (Vec3(-0.2 * std::sqrt(0.5), 0, 0.2 * std::sqrt(0.5)) + 1.5 * step * t.velocity)).norm() <
          1e-13);
}

TEST_CASE("the truth is a hit; late, wrong and missing answers are told apart", "[tunnel]")
{
    for (const Target target : {Target::plate, Target::sphere, Target::wall}) {
        CellThrows throws(cell_of(target));
        const Throw& t = throws.at({0.5, 0});
        CHECK(judge(truthful(), t, step).fate == Fate::hit);
        CHECK(judge(truthful(), t, step).error == 0);
        CHECK(judge(truthful(0.4 * step), t, step).fate == Fate::hit);  // still in its step
        CHECK(judge(truthful(0.6 * step), t, step).fate == Fate::wrong);
        CHECK(judge(truthful(1.6 * step), t, step).fate == Fate::tunnelled);  // beyond two steps
        CHECK(judge(truthful(0, 0.015), t, step).fate == Fate::hit);          // 1.5 % of v is 0.75 % of |dv|
        CHECK(judge(truthful(0, 0.025), t, step).fate == Fate::wrong);
        CHECK(judge(blind(), t, step).fate == Fate::tunnelled);
        CHECK(judge(blind(), t, step).error == Approx(2 * 40 * 1.5 * step));
    }
}

TEST_CASE("who claims to be exact is held to 1e-9", "[tunnel]")
{
    CellThrows throws(cell_of(Target::plate));
    const Throw& t = throws.at({0.5, 0});
    for (const auto& [late, slower] : {std::pair(1e-8 * 0.1 / 40, 0.0), std::pair(0.0, 1e-8)}) {
        Contestant who = truthful(late, slower);
        CHECK(judge(who, t, step).fate == Fate::hit);
        who.is_exact = true;
        CHECK(judge(who, t, step).fate == Fate::wrong);
    }
    Contestant right = truthful();
    right.is_exact = true;
    CHECK(judge(right, t, step).fate == Fate::hit);
}

TEST_CASE("a spring that gives way behind a plate has tunnelled, one that holds is only slow", "[tunnel]")
{
    // The spring keeps contact for ten steps: it comes as deep as v / omega, omega = pi / (10 dt).
    Cell cell = cell_of(Target::plate);
    const double reach = cell.radius + *cell.thickness / 2;
    const double holds = 0.29 * reach / step, gives = 0.35 * reach / step;
    for (const double speed : {holds, gives}) {
        cell.speed = speed;
        CellThrows throws(cell);
        const Fate fate = judge(contestant("penalty"), throws.at({0.5, 0}), step).fate;
        CHECK(fate == (speed == holds ? Fate::wrong : Fate::tunnelled));
    }
}
