/// Several contacts at once in the engine: what belongs to one instant, and that no broad phase changes it. What their
/// impacts and forces give is asked in tests/scenario.
#include "gather/instant.hpp"
#include "motion/state.hpp"
#include "support/scenes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

/// Runs to its end, with the same events from grid and all pairs.
Outcome require_resolved(const Scene& scene)
{
    const Outcome grid = record(scene, EventDriven{BroadPhase::cell_grid}).outcome;
    const Outcome pairs = record(scene, EventDriven{BroadPhase::all_pairs}).outcome;
    INFO(name(pairs.status) << " at " << pairs.time << ": " << pairs.message);
    CHECK(pairs.status == Status::reached_end);
    CHECK(grid.event_hash == pairs.event_hash);
    for (const auto& state : pairs.final) {
        CHECK(state.position.allFinite());
        CHECK(state.velocity.allFinite());
    }
    return pairs;
}

}  // namespace

TEST_CASE("the hit on one of two touching spheres goes on to the other at once")
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {1, 0, 0});
    const Outcome outcome = require_resolved(scene);
    CHECK(outcome.counts.clusters == 1);
    CHECK(outcome.counts.impacts == 2);
    CHECK(outcome.final[2].velocity.x() == Approx(1));
    CHECK(outcome.final[0].velocity.x() == Approx(0).margin(1e-15));
}

TEST_CASE("two spheres that hit a third at one instant are one cluster")
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {2, 0, 0}, {-1, 0, 0});
    const Outcome outcome = require_resolved(scene);
    CHECK(outcome.counts.clusters == 1);
    CHECK(outcome.final[1].velocity.isZero(1e-15));
    CHECK(outcome.final[0].velocity.x() == Approx(-1));
}

TEST_CASE("a sphere that hits two touching ones at once leaves symmetrically, whatever rounding makes of the tie")
{
    Random random(4);
    for (int i = 0; i < 50; ++i) {
        const Vec3 ahead = random.direction(), across = random.across(ahead);
        Scene scene = empty_scene(3);
        add_sphere(scene, 0.5, -2 * ahead, ahead);
        for (const double side : {0.5, -0.5}) add_sphere(scene, 0.5, std::sqrt(0.75) * ahead + side * across);
        const Outcome outcome = require_resolved(scene);
        CHECK(outcome.counts.clusters == 1);
        CHECK(outcome.final[0].velocity.dot(ahead) == Approx(-0.2).epsilon(1e-12));
        CHECK(std::abs(outcome.final[0].velocity.dot(across)) <= 1e-12);
    }
}

TEST_CASE("two separate impacts at one instant are no cluster")
{
    Scene scene = empty_scene(2);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {-2, 5, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 5, 0});
    const Recorded run = record(scene);
    CHECK(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.counts.clusters == 0);
    REQUIRE(run.events.size() == 2);
    CHECK(run.events[0].at == run.events[1].at);
}

TEST_CASE("a corner is one impact of two contacts, an edge passed one wall after the other is not")
{
    Scene scene = empty_scene(3);
    add_plane(scene, "left", Vec3::UnitX());
    add_plane(scene, "front", Vec3::UnitY());
    add_sphere(scene, 0.5, {2, 2, 0}, {-1, -1, 0});
    const Outcome corner = require_resolved(scene);
    CHECK(corner.counts.clusters == 1);
    CHECK(corner.final[0].velocity == Vec3(1, 1, 0));

    scene.spheres[0].position.y() = 2.001;
    const Outcome edge = require_resolved(scene);
    CHECK(edge.counts.clusters == 0);
    CHECK(edge.counts.impacts == 2);
    CHECK(edge.final[0].velocity == Vec3(1, 1, 0));
}

TEST_CASE("a sphere at rest on a resting sphere stays, and the floor carries both")
{
    Scene scene = empty_scene(3, earth, 0.5);
    add_floor(scene);
    add_sphere(scene, 0.5, {0, 0, 0.5});
    add_sphere(scene, 0.5, {0, 0, 1.5});
    const Outcome outcome = require_resolved(scene);
    CHECK(outcome.counts.impacts == 0);
    CHECK(outcome.final[1].mode == Mode::resting);
    CHECK(outcome.final[1].position == Vec3(0, 0, 1.5));
    CHECK(outcome.plane_impulses[0] == Approx(2 * 9.81 * 3).epsilon(1e-12));
}

TEST_CASE("a sphere falls into a V groove, or lies there, and rests in it")
{
    for (const double height : {0.0, 0.5})
        for (const double offset : {0.0, 0.03}) {
            Scene scene = empty_scene(20, earth, 0.5);
            add_plane(scene, "left", {1, 0, 1});
            add_plane(scene, "right", {-1, 0, 1});
            add_sphere(scene, 0.1, {height > 0 ? offset : 0, 0, 0.1 * std::sqrt(2.0) + height});
            INFO("height " << height << ", offset " << offset);
            const Outcome outcome = require_resolved(scene);
            CHECK(outcome.final[0].mode == Mode::resting);
            CHECK(outcome.final[0].position.z() == Approx(0.1 * std::sqrt(2.0)).epsilon(1e-12));
            CHECK(std::abs(outcome.final[0].position.x()) <= 1e-12);
        }
}

TEST_CASE("an inelastic sphere squeezed between two others stays with them, and momentum is kept")
{
    Scene scene = empty_scene(10, Vec3::Zero(), 0.05);
    add_sphere(scene, 0.5, {-2, 0, 0}, {1, 0, 0});
    add_sphere(scene, 0.5, {0, 0, 0});
    add_sphere(scene, 0.5, {2.0625, 0, 0}, {-1, 0, 0});
    const Outcome outcome = require_resolved(scene);
    double momentum = 0;
    for (const auto& state : outcome.final) momentum += state.velocity.x();
    CHECK(std::abs(momentum) <= 1e-15);
    CHECK(outcome.counts.impacts < 100);
    CHECK(outcome.counts.guarded == 0);
}

TEST_CASE("impacts that accumulate are handed to the guard; without it that is said, long before they are a tie")
{
    // A light ball between the floor and a heavy one that comes down: thousands of bounces in a millisecond. 111
    // of a body are none that accumulate where B = 1.
    Scene scene = empty_scene(1, Vec3::Zero(), 0.99);
    scene.guard.impacts = 1;
    scene.rest.numeric_step = 1e-2;
    scene.rest.closing_speed = scene.rest.window = 0;  // without these rules, that is
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.1005}, Vec3::Zero(), 1e-6);
    add_sphere(scene, 0.1, {0, 0, 0.301}, {0, 0, -1}, 1e6);
    const Outcome guarded = require_resolved(scene);
    CHECK(guarded.counts.guarded > 0);
    CHECK(guarded.body_seconds.guarded > 0);
    // A mass ratio of 1e12 leaves few digits; what they leave is said.
    CHECK(guarded.max_penetration < 1e-5 * 0.1);
    CHECK(guarded.final[0].position.z() >= 0.1 - 1.001 * guarded.max_penetration);

    scene.guard.on = false;
    const Outcome outcome = record(scene).outcome;
    CHECK(outcome.status == Status::unresolved);
    CHECK(outcome.message.find("s0") != std::string::npos);
    CHECK(outcome.message.find("accumulate") != std::string::npos);
    CHECK(outcome.message.find("at t = ") != std::string::npos);
    CHECK(outcome.counts.impacts > 90);
    CHECK(outcome.counts.impacts < 300);
}

TEST_CASE("a sphere that slides to rest at a second plane rests on both")
{
    Scene scene = empty_scene(3, earth, 0);
    add_floor(scene);
    add_plane(scene, "wall", -Vec3::UnitX(), -2);
    add_sphere(scene, 0.5, {0, 0, 0.5}, {1, 0, 0});
    const Outcome outcome = require_resolved(scene);
    CHECK(outcome.final[0].mode == Mode::resting);
    CHECK(outcome.final[0].position.x() == Approx(1.5).epsilon(1e-15));
    CHECK(*outcome.rest_times[0] == 0);
}

TEST_CASE("a contact that closed a moment ago belongs to the instant of another while it is hardly open")
{
    Scene scene = empty_scene(1, earth, 0.5);
    for (const double x : {0.0, 0.3, 0.6}) add_sphere(scene, 0.1, {x, 0, 1});
    State state(scene, Precision::plain);
    const double height = state.rest.closing_speed * state.rest.closing_speed / (2 * 9.81);
    CHECK(state.rebound_gap == Approx(height));
    const auto at = [&](double t) { return state.frame.after({}, t); };
    state.recent.add(0, 1, at(0.5));
    const EpochTime soon = at(0.5 + state.rest.window / 2), later = at(0.5 + 2 * state.rest.window);
    struct Nobody final : Neighbourhood {
        std::span<const BodyId> operator()(BodyId) const override { return {}; }
        bool is_alone(BodyId, Partner, const EpochTime&) const override { return false; }
    };
    const Nobody nobody;
    const auto closed = [&](BodyId a, BodyId b, double gap, const EpochTime& time) {
        const Key key{time, Scheduled::pair_impact, 1, Partner::sphere(2)};
        return ContactInstant(state, key, nobody).closed(a, Partner::sphere(b), gap);
    };
    CHECK(closed(0, 1, 0.9 * height, soon) == Closed::in_heaps);
    CHECK(closed(1, 0, 0.9 * height, soon) == Closed::in_heaps);
    CHECK(closed(0, 1, 1.1 * height, soon) == Closed::no);
    CHECK(closed(0, 1, 0.9 * height, later) == Closed::no);
    CHECK(closed(1, 2, 0.9 * height, soon) == Closed::no);
    // What has not bounced is closed within the tie, what has within the rounding of places.
    CHECK(closed(1, 2, 0.5e-12 * 0.1, soon) == Closed::yes);
    CHECK(closed(0, 1, 0.5e-12 * 0.1, soon) == Closed::in_heaps);
    CHECK(closed(0, 1, 0x1p-53 * 0.1, soon) == Closed::yes);
    CHECK(State(scene, Precision::certified).rebound_gap == 0);
    scene.rest.policy = RestPolicy::micro;
    CHECK(State(scene, Precision::plain).rebound_gap == 0);
}

TEST_CASE("what has rolled and comes to rest touches, within the gap tolerance")
{
    const Scene scene = shaft(1, 10, 3);
    const Outcome outcome = require_resolved(scene);
    CHECK(outcome.counts.numeric_steps > 100);
    double worst = 0;
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(outcome.final[i].mode == Mode::resting);
        for (std::size_t j = 0; j < i; ++j) {
            const double gap = (outcome.final[i].position - outcome.final[j].position).norm() -
                               scene.spheres[i].radius - scene.spheres[j].radius;
            if (std::abs(gap) < 1e-6) worst = std::max(worst, std::abs(gap));
        }
    }
    INFO(worst);
    CHECK(worst < 1e-13);  // far less than the tolerance: the ends of numeric pieces are mended
}

TEST_CASE("a heap settles: nothing is lost, nothing sinks, energy does not grow")
{
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const Scene scene = gas(seed, 30, 6, earth, 0.5);
        const Outcome outcome = require_resolved(scene);
        CHECK(outcome.counts.guarded == 0);
        CHECK(outcome.max_penetration <= 1e-6 * scene.spheres[0].radius);
    }
}
