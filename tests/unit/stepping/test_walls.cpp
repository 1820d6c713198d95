#include "run_all.hpp"
#include "small_scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// Dropped from height 1 on a floor of restitution 0.8.
Scene bouncing_ball()
{
    Scene scene = scene_of({ball(0.1, Vec3(0, 0, 1.1))}, {wall(Vec3::UnitZ(), 0)}, Vec3(0, 0, -9.81));
    scene.materials[0].restitution = 0.8;
    return scene;
}

/// A ball of mass 2 flies at a wall 0.25 away at speed 3; restitution 0.5.
Scene thrown_at_wall()
{
    Scene scene = scene_of({ball(0.1, Vec3(0.35, 0, 0), Vec3(-3, 0, 0), 2)}, {wall(Vec3::UnitX(), 0)});
    scene.materials[0].restitution = 0.5;
    return scene;
}

}  // namespace

TEST_CASE("Under naive a bouncing ball sinks through the floor and sticks in it; the others keep it above",
          "[stepping]")
{
    const Outcome naive = run_discrete(bouncing_ball(), Naive{steps(1.0 / 60)}, until(5));
    CHECK(naive.final[0].position.z() < 0);
    CHECK(naive.counts.impacts > 100);  // one a step: it sticks
    for (const Method& method : all_serious(steps(1.0 / 60))) {
        CAPTURE(name(method));
        CHECK(run_discrete(bouncing_ball(), method, until(5)).final[0].position.z() > 0);
    }
}

TEST_CASE("pbd and bisection leave a bouncing ball on the floor, velocity at most one step of fall in it", "[stepping]")
{
    CHECK(run_discrete(bouncing_ball(), PositionBased{steps(1.0 / 240)}, until(10)).final[0].position.z() >
          0.1 - 1e-12);
    CHECK(run_discrete(bouncing_ball(), Bisection{steps(1.0 / 240)}, until(10)).final[0].position.z() > 0.1 - 1e-12);
    CHECK(run_discrete(bouncing_ball(), VelocityBased{steps(1.0 / 240)}, until(10)).final[0].position.z() >
          0.1 - 4.5 / 240);
}

TEST_CASE("Penetration is recorded at the end of the substep before correction", "[stepping]")
{
    // dt = 0.1: positions 0.35, 0.05 (0.05 deep), then out at 1.5 a unit time.
    for (const Method& method : all_discrete(steps(0.1))) {
        CAPTURE(name(method));
        if (name(method) == "penalty") continue;  // deeper for some more steps
        const bool is_inside = name(method) == "bisection" || looks_ahead(method);
        const Outcome one = run_discrete(thrown_at_wall(), method, until(0.1));
        CHECK(one.max_penetration == Approx(is_inside ? 0 : 0.05).margin(1e-14));
        CHECK(run_discrete(thrown_at_wall(), method, until(0.3)).max_penetration == Approx(one.max_penetration));
    }
}

TEST_CASE("A bounce is one impact, and its impulse is in the event and on the plane", "[stepping]")
{
    for (const Method& method : all_impulsive(steps(0.1))) {
        CAPTURE(name(method));
        std::vector<Event> events;
        Observer observer;
        observer.on_event = [&](const Event& e) { events.push_back(e); };
        const Outcome outcome = run_discrete(thrown_at_wall(), method, until(0.3), observer);
        REQUIRE(events.size() == 1);
        CHECK(outcome.counts.impacts == 1);
        CHECK(events[0].kind == EventKind::impact);
        CHECK((events[0].a == 0 && events[0].b == 1));
        CHECK(events[0].normal == Vec3::UnitX());
        CHECK((events[0].impulse - Vec3(9, 0, 0)).norm() < 1e-14);
        CHECK(events[0].at == EpochTime{0, events[0].time});
        const double at =
            name(method) == "bisection" || name(method) == "toi" ? 0.25 / 3 : 0.1;  // velocity sees it a step later
        CHECK(events[0].time == Approx(at).epsilon(1e-14));
        REQUIRE(outcome.plane_impulses.size() == 1);
        CHECK(outcome.plane_impulses[0] == Approx(9));
        CHECK((outcome.final[0].velocity - Vec3(1.5, 0, 0)).norm() < 1e-15);
    }
}

TEST_CASE("After a pbd step the wall is free of overlap, the pair is not; each pass halves what is left", "[stepping]")
{
    // Sphere 0 touches the wall; sphere 1 overlaps it by 0.04. Half of a projection goes into the wall and comes back.
    const Scene scene = scene_of({ball(0.1, Vec3(0.1, 0, 0)), ball(0.1, Vec3(0.26, 0, 0))}, {wall(Vec3::UnitX(), 0)});
    double left = 0.04;
    for (const int passes : {1, 2, 3, 6}) {
        const Outcome outcome = run_discrete(scene, PositionBased{steps(0.01, 1, passes)}, until(0.01));
        left = std::ldexp(0.04, -passes);
        CAPTURE(passes);
        CHECK(outcome.final[0].position.x() - 0.1 == Approx(0).margin(1e-15));
        CHECK(0.2 - (outcome.final[1].position - outcome.final[0].position).norm() == Approx(left).epsilon(1e-10));
        CHECK(outcome.max_penetration == Approx(0.04));
    }
    const Outcome substeps = run_discrete(scene, PositionBased{steps(0.01, 3)}, until(0.01));
    CHECK(0.2 - (substeps.final[1].position - substeps.final[0].position).norm() == Approx(0.005));
}

TEST_CASE("Under velocity a bounce that another contact makes approach again is cancelled, not undone", "[stepping]")
{
    // Ball 1 falls on ball 0, which lies on the floor. B: they swap, ball 0 bounces off the floor and runs into ball 1,
    // now at rest. C: that approach is cancelled, both rise at half the speed.
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 0.1)), ball(0.1, Vec3(0, 0, 0.25), Vec3(0, 0, -1))}, {wall(Vec3::UnitZ(), 0)});
    std::vector<Event> events;
    Observer observer;
    observer.on_event = [&](const Event& e) { events.push_back(e); };
    const Outcome outcome = run_discrete(scene, VelocityBased{steps(1e-4)}, until(1e-4), observer);
    CHECK((outcome.final[0].velocity - Vec3(0, 0, 0.5)).norm() < 1e-15);
    CHECK((outcome.final[1].velocity - Vec3(0, 0, 0.5)).norm() < 1e-15);
    CHECK(outcome.counts.impacts == 2);  // the pair got two impulses: one impact
    REQUIRE(events.size() == 2);
    CHECK((events[0].a == 0 && events[0].b == 1));
    CHECK((events[0].impulse - Vec3(0, 0, -1.5)).norm() < 1e-15);
    CHECK((events[1].impulse - Vec3(0, 0, 2)).norm() < 1e-15);
}

TEST_CASE("With passes a contact of pbd counts once a substep", "[stepping]")
{
    const Scene scene =
        scene_of({ball(0.1, Vec3(0, 0, 0.1)), ball(0.1, Vec3(0, 0, 0.25), Vec3(0, 0, -1))}, {wall(Vec3::UnitZ(), 0)});
    std::vector<Event> events;
    Observer observer;
    observer.on_event = [&](const Event& e) { events.push_back(e); };
    const Outcome outcome = run_discrete(scene, PositionBased{steps(1e-4, 1, 2)}, until(1e-4), observer);
    CHECK(outcome.counts.impacts == static_cast<std::int64_t>(events.size()));
    REQUIRE(events.size() == 2);
    // Pass 1: swap, floor bounce; pass 2: swap again.
    CHECK((outcome.final[1].velocity - Vec3(0, 0, 1)).norm() < 1e-15);
    CHECK((events[0].impulse - Vec3(0, 0, -2)).norm() < 1e-15);
    CHECK((events[1].impulse - Vec3(0, 0, 2)).norm() < 1e-15);
}

TEST_CASE("A wall contact is visited once a pass, also for a sphere that a pair has just moved", "[stepping]")
{
    // Sphere 0 is in the wall before and after the pair is projected. Literal: swap, then one reflection; twice would
    // be none.
    const Scene scene =
        scene_of({ball(0.1, Vec3(0.09, 0, 0), Vec3(-1, 0, 0)), ball(0.1, Vec3(0.25, 0, 0), Vec3(-2, 0, 0))},
                 {wall(Vec3::UnitX(), 0)});
    PositionBased method{steps(1e-9)};
    method.literal = true;
    const Outcome outcome = run_discrete(scene, method, until(1e-9));
    CHECK(outcome.counts.impacts == 2);
    CHECK(outcome.final[0].velocity.x() == 2);
    CHECK(outcome.final[1].velocity.x() == -1);
}
