#include "support/multiprecision.hpp"
#include "support/recorded.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;

namespace {

Scene bouncing_ball()
{
    Scene scene = empty_scene(5, earth, 0.8);
    add_sphere(scene, 0.1, {0, 0, 1.1}, {0.2, 0, 0});
    add_floor(scene);
    return scene;
}

}  // namespace

TEST_CASE("true runs hold: gases, gravity, losses, radii of all sizes", "[verify]")
{
    for (const double restitution : {1.0, 0.9})
        for (const Vec3& gravity : {Vec3(Vec3::Zero()), Vec3(0, 0, -1)})
            for (const double smallest : {0.3, 0.003}) {
                const Scene scene = gas(5, 60, 3, gravity, restitution, smallest, 0.5);
                const MemorySource source = recorded(scene);
                const Certificate c = examined(source);
                INFO(first_violation(c));
                CHECK(c.holds());
                CHECK(c.complete);
                CHECK(c.until == source.description.end->time);
                CHECK(c.events == static_cast<std::int64_t>(source.events.size()));
                CHECK(c.impulses > 50);
                CHECK(c.event_hash == source.description.end->event_hash);
                CHECK(c.body_seconds.not_certified == 0);
                CHECK(c.body_seconds.exact + c.body_seconds.bounded == Approx(60 * c.until));
                CHECK(c.largest_impulse_error < 1e-15);
                CHECK(c.largest_jump < 1);
            }
}

TEST_CASE("series, slides, rests and fixed spheres hold", "[verify]")
{
    const Certificate ball = examined(recorded(bouncing_ball()));
    INFO(first_violation(ball));
    CHECK(ball.holds());
    CHECK(ball.body_seconds.not_certified == 0);
    const MemorySource source = recorded(every_mode());
    const auto has = [&](Mode mode) {
        return std::any_of(source.flights.begin(), source.flights.end(), [&](const auto& f) { return f.mode == mode; });
    };
    for (const Mode mode : {Mode::flying, Mode::series, Mode::sliding, Mode::fixed}) CHECK(has(mode));
    const Certificate all = examined(source);
    INFO(first_violation(all));
    CHECK(all.holds());
}

TEST_CASE("overlaps of bodies that cannot move are none, and a floor of such spheres holds", "[verify]")
{
    Scene scene = empty_scene(3, earth, 0.5);
    add_floor(scene);
    for (int k = -3; k <= 3; ++k) {
        add_sphere(scene, 0.3, {0.25 * k, 0.1 * (k % 2), 0});
        scene.spheres.back().fixed = true;
    }
    add_sphere(scene, 0.2, {0.05, 0.02, 2});
    for (const bool certified : {false, true}) {
        MemorySource source = recorded(scene, {}, certified);
        const Certificate c = examined(source);
        INFO(first_violation(c));
        CHECK(c.holds());
        CHECK(c.impulses > 1);
        CHECK(c.smallest_gap > -1e-15);
        CHECK(c.body_seconds.not_certified == 0);
        source.flights.resize(scene.spheres.size());  // the ball falls through
        source.after.resize(scene.spheres.size());
        source.events.clear();
        source.seal();
        CHECK_FALSE(examined(source).holds());
    }
}

TEST_CASE("contacts that the scene's tie closes together hold; what is open by more than the tie is refused",
          "[verify]")
{
    const auto is_refused_for_its_gap = [](const Certificate& c) {
        return std::any_of(c.violations.begin(), c.violations.end(), [](const Violation& violation) {
            return violation.what.find("is pushed at a gap of 5e-05") != std::string::npos;
        });
    };
    for (const double restitution : {1.0, 0.5})
        for (const ImpactOperator impact_operator :
             {ImpactOperator::reflections, ImpactOperator::sequential, ImpactOperator::lcp}) {
            Scene scene = empty_scene(3, Vec3::Zero(), restitution);
            add_sphere(scene, 1, {0, 0, 0}, {1, 0, 0});
            add_sphere(scene, 1, {3, 0, 0});
            add_sphere(scene, 1, {5.00005, 0, 0});
            scene.impact.impact_operator = impact_operator;
            scene.impact.tie = 1e-4;
            MemorySource source = recorded(scene);
            const Certificate c = examined(source);
            INFO(first_violation(c));
            CHECK(c.holds());
            CHECK(c.clusters >= 1);
            CHECK(c.largest_impact_gap == Approx(5e-5));
            for (const double tie : {0.0, 4.9e-5}) {
                source.description.tie = tie;
                CHECK(is_refused_for_its_gap(examined(source)));
            }
        }
    for (const double tie : {1e-6, 1e-4, 1e-2}) {  // crowded, so that ties are common
        Scene scene = gas(6, 150, 2, {0, 0, -1}, 1, 0.4, 0.5, 6);
        scene.impact.tie = tie;
        const Certificate c = examined(recorded(scene));
        CAPTURE(tie);
        INFO(first_violation(c));
        CHECK(c.holds());
        if (tie == 1e-2) CHECK(c.largest_impact_gap > 1e-4 * 0.4);
    }
}

TEST_CASE("heaps that settle hold; impulses at gaps of contacts that closed long ago are refused", "[verify]")
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        MemorySource source = recorded(shaft(seed, 16, 1.5));
        const Certificate true_run = examined(source);
        INFO(first_violation(true_run));
        CHECK(true_run.holds());
        CHECK(true_run.settles > 0);
        CHECK(true_run.largest_impact_gap > 1e-9 * 0.034);
        source.description.window /= 10;
        const Certificate strict = examined(source);
        CHECK(std::any_of(strict.violations.begin(), strict.violations.end(), [](const Violation& violation) {
            return violation.what.find("is pushed at a gap") != std::string::npos;
        }));
    }
}

TEST_CASE("heaps in which pushes and pulls of one instant cancel hold; closing again and again needs no guard",
          "[verify]")
{
    std::int64_t guards = 0;
    for (const std::uint64_t seed : {146, 166, 236, 263}) {
        const MemorySource source = recorded(shaft(seed, 16, 1.5));
        const Certificate c = examined(source);
        INFO(first_violation(c));
        CHECK(c.holds());
        guards += c.guards;
    }
    CHECK(guards <= 1);
}

TEST_CASE("the smallest gap is that of all pairs in many digits", "[verify]")
{
    for (const Vec3& gravity : {Vec3(Vec3::Zero()), Vec3(0, 0, -1)})
        for (const int count : {10, 50}) {
            const Scene scene = gas(7, count, count == 10 ? 3 : 0.4, gravity);
            const MemorySource source = recorded(scene);
            REQUIRE(source.events.size() > 10);
            const double oracle = smallest_gap<Float200>(source).convert_to<double>();
            const Certificate grid = examined(source), all = examined(source, true);
            CHECK(grid.smallest_gap == Approx(oracle).epsilon(1e-9));
            CHECK(all.smallest_gap == grid.smallest_gap);
            CHECK(all.body_seconds.exact == Approx(grid.body_seconds.exact));
        }
    // Nobody touches anybody.
    Scene apart = empty_scene(10);
    add_sphere(apart, 1, {0, 0, 0}, {1, 0, 0});
    add_sphere(apart, 1, {10, 3, 0}, {-1, 0, 0});
    const MemorySource source = recorded(apart);
    CHECK(examined(source).smallest_gap == Approx(1).epsilon(1e-14));
}

TEST_CASE("certified runs hold where bodies leave free flight, too, and where what falls meets what does not",
          "[verify]")
{
    Scene series = empty_scene(3, {0, 0, -9.81}, 0.5);
    add_floor(series);
    add_sphere(series, 0.3, {0.1, 0, 0.77}, {0.1, 0.2, 0});
    Scene onto_fixed = empty_scene(2, {0, 0, -9.81});
    add_sphere(onto_fixed, 0.3, {0.1, 0, 0.77});
    add_sphere(onto_fixed, 0.3, {0, 0, 0});
    onto_fixed.spheres[1].fixed = true;
    for (const Scene& scene : {series, onto_fixed}) {
        const Certificate c = examined(recorded(scene, {}, true));
        INFO(first_violation(c));
        CHECK(c.certified);
        CHECK(c.holds());
        CHECK(c.impulses > 0);
    }
    // What both do in free flight is still held to gaps of 0, and to double-double.
    MemorySource moved = recorded(gas(9, 60, 2, {0, 0, -1}), {}, true);
    CHECK(examined(moved).holds());
    const auto low = std::find_if(moved.flights.begin() + 60, moved.flights.end(),
                                  [](const FlightRecord& f) { return f.local_low[0] != 0; });
    REQUIRE(low != moved.flights.end());
    low->local_low[0] += 1e-25;
    CHECK_FALSE(examined(moved).holds());
}

TEST_CASE("double-double flights made by hand hold as certified", "[verify]")
{
    // Two spheres meet at a time that is no double of the contact: a's impact is put a little early, at a gap > 0.
    MemorySource source;
    RecordedRun& run = source.description;
    run.certified = true;
    run.frame = {1, 1, 0, {Vec3::Zero()}};
    run.materials = {Material{"default", 1, 1, ""}};
    run.spheres = {{0.3, 1, 0, false}, {0.3, 1, 0, false}};
    run.starts = {{{0.1, 0.1, 0.1}, {0.7, 0, 0}}, {{1.1, 0.1, 0.1}, {0, 0, 0}}};
    const double t = 0.4 / 0.7 * (1 - 1e-16);
    FlightRecord a;
    a.body = 0;
    a.local = {0.1, 0.1, 0.1};
    a.velocity = {0.7, 0, 0};
    FlightRecord b = a;
    b.body = 1;
    b.cell[0] = 1;
    b.local[0] = 1.1 - 1;
    b.velocity[0] = 0;
    source.flights = {a, b};
    a.start = b.start = {0, t};
    const Sum travel = two_product(0.7, t);
    const DoubleDouble x = DoubleDouble(0.1) + DoubleDouble(travel);
    a.local = {x.high, 0.1, 0.1};
    a.local_low[0] = x.low;
    a.velocity[0] = 0;
    b.velocity[0] = 0.7;
    source.flights.push_back(a);
    source.flights.push_back(b);
    source.after = {0, 0, 1, 1};
    Event e{EventKind::impact, {0, t}, t, 0, 1, {-1, 0, 0}, {-0.7, 0, 0}};
    source.events = {e};
    run.end = RecordedEnd{2, 0, 0, 0};
    source.seal();
    const Certificate c = examined(source);
    INFO(first_violation(c));
    CHECK(c.holds());
    CHECK(c.body_seconds.exact == Approx(4));
    CHECK(c.smallest_gap >= 0);
    CHECK(c.smallest_gap < 1e-15);

    MemorySource forged = source;
    forged.flights[2].local_low[0] += 1e-24;  // far below double, above double-double
    CHECK_FALSE(examined(forged).holds());
}

TEST_CASE("overlaps of the start may stay, not deepen", "[verify]")
{
    Scene scene = empty_scene(1);
    add_sphere(scene, 1, {0, 0, 0}, {0, 0.5, 0});
    add_sphere(scene, 1, {2 - 1e-10, 0, 0}, {0, 0.5, 0});
    MemorySource source = recorded(scene);
    REQUIRE(source.events.empty());
    CHECK(examined(source).holds());
    CHECK(examined(source).body_seconds.exact == Approx(2));
    for (const double speed : {1e-3, -1e-3}) {
        MemorySource moving = source;
        moving.flights[0].velocity[0] = speed;
        moving.description.starts[0].velocity.x() = speed;
        CHECK(examined(moving).holds() == (speed < 0));
    }
}
