/// Runs under linear drag, dv/dt = g - k v, against its formulas in 50 digits and the laws that follow from them.
#include "support/multiprecision.hpp"
#include "support/scenes.hpp"

#include <carom/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;
using Real = Float<50>;

namespace {

constexpr double g = 9.81;

Scene damped(Scene scene, double drag)
{
    scene.drag = drag;
    return scene;
}

/// A ball of radius 0.1 at a height above the floor z = 0.
Scene dropped(double height, double drag, double restitution, double end_time)
{
    Scene scene = damped(empty_scene(end_time, earth, restitution), drag);
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.1 + height}, {0.3, -0.2, 0});
    return scene;
}

/// A bounce on a level floor: the time until the ball is down again, and the speed with which it arrives.
struct Landing {
    Real time, speed;
};
/// \param height above the floor, from which it leaves upwards at `speed`
Landing landing(const Real& height, const Real& speed, const Real& k)
{
    // Newton's method from the right, where the height is below 0 and falls ever faster or as fast.
    const auto at = [&](const Real& t, Real& h, Real& w) {
        const Real decay = exp(-k * t), way = (1 - decay) / k, fall = (t - way) / k;
        h = height + speed * way - g * fall;
        w = speed * decay - g * way;
    };
    Real t =
        (2 * speed + height * k + sqrt((2 * speed + height * k) * (2 * speed + height * k) + 8 * g * height)) / (2 * g);
    Real h, w;
    for (int i = 0; i < 100; ++i) {
        at(t, h, w);
        t -= h / w;
    }
    at(t, h, w);
    return {t, -w};
}

/// Impacts of an elastic gas or one that loses energy, without walls that would tell one run from the other by time.
std::vector<std::pair<BodyId, BodyId>> partners(const std::vector<Event>& events, std::size_t count)
{
    std::vector<std::pair<BodyId, BodyId>> out;
    for (std::size_t i = 0; i < std::min(count, events.size()); ++i) out.emplace_back(events[i].a, events[i].b);
    return out;
}

std::uint64_t hash_of(const Scene& scene, BroadPhase broad_phase)
{
    EventDriven method;
    method.broad_phase = broad_phase;
    const Recorded run = record(scene, method);
    INFO(run.outcome.message);
    CHECK(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.kernel == "damped");
    return run.outcome.event_hash;
}

}  // namespace

TEST_CASE("ten bounces under drag come at the times, at the speeds and at the places that 50 digits have", "[drag]")
{
    for (const double k : {1e-12, 1e-3, 0.3, 2.0, 20.0}) {
        CAPTURE(k);
        const double e = 0.9, height = 0.5;
        Real time = 0, speed = 0, above = Real(0.1 + height) - Real(0.1);
        std::vector<Real> times;
        for (int bounce = 0; bounce < 10; ++bounce) {
            const Landing down = landing(above, speed, k);
            time += down.time;
            times.push_back(time);
            speed = e * down.speed;
            above = 0;
        }
        const double end = static_cast<double>(time) * (1 + 1e-9);
        const Recorded run = record(dropped(height, k, e, end));
        REQUIRE(run.outcome.status == Status::reached_end);
        REQUIRE(run.events.size() >= 10);
        for (std::size_t i = 0; i < 10; ++i)
            CHECK(std::abs(static_cast<double>(Real(run.events[i].time) - times[i])) <
                  1e-14 * static_cast<double>(times[i]));
        // The impulse of the tenth is (1 + e) times its speed.
        CHECK(run.events[9].impulse.z() == Approx((1 + e) / e * static_cast<double>(speed)).epsilon(1e-13));
        const Real way = (1 - exp(-k * Real(end))) / k;
        CHECK(run.outcome.final[0].position.x() == Approx(static_cast<double>(0.3 * way)).epsilon(1e-14));
        CHECK(run.outcome.final[0].velocity.y() == Approx(-0.2 * std::exp(-k * end)).epsilon(1e-14));
    }
}

TEST_CASE("bounces on a floor go on to rounding under drag, and end where those in 50 digits do", "[drag]")
{
    for (const double k : {0.01, 1.0, 30.0}) {
        for (const double e : {0.2, 0.6, 0.9}) {
            CAPTURE(k, e);
            Real time = 0, speed = 0, above = Real(0.1 + 0.7) - Real(0.1);
            int bounces = 0;
            for (; bounces == 0 || speed > Real(1e-40); ++bounces) {
                const Landing down = landing(above, speed, k);
                time += down.time;
                speed = e * down.speed;
                above = 0;
            }
            const Recorded run = record(dropped(0.7, k, e, static_cast<double>(time) + 5));
            REQUIRE(run.outcome.status == Status::reached_end);
            CHECK(run.outcome.counts.guarded == 0);
            CHECK(run.outcome.counts.rests == 1);
            CHECK(run.outcome.counts.early_rests == 0);
            REQUIRE(run.outcome.rest_times[0]);
            // The last bounces, w^2/g < 32 u (r + cell) = 32 u (0.1 + 0.25), are left out: 2 w / (g (1 - e)) of time.
            const double last = 1.105e-7, left_out = 2 * last / g / (1 - e);
            CHECK(std::abs(*run.outcome.rest_times[0] - static_cast<double>(time)) < left_out);
            CHECK(static_cast<double>(run.outcome.counts.impacts) > 0.9 * bounces * std::log(last) / std::log(1e-40));
            CHECK(run.outcome.final[0].mode == Mode::sliding);
            CHECK(run.outcome.final[0].position.z() == Approx(0.1).epsilon(1e-15));
        }
    }
}

TEST_CASE("bounces that take of the tangential speed take all of it by the time they end under drag", "[drag]")
{
    Scene scene = dropped(0.5, 0.4, 0.55, 4);
    scene.materials[0].tangential = 0.9;
    const Outcome out = simulate(scene, EventDriven{});
    REQUIRE(out.status == Status::reached_end);
    REQUIRE(out.rest_times[0]);
    CHECK(out.final[0].velocity.isZero(0));
    CHECK(out.final[0].mode == Mode::resting);
    // Below e^n of the first speed bounces are rounding; 0.9^n of 0.36 m/s would be left after some 30.
    CHECK(out.counts.impacts < 60);
}

TEST_CASE("a ball that bounces on a fixed one under drag comes to rest as 50 digits have it", "[drag]")
{
    const double k = 0.8, e = 0.7;
    Scene scene = damped(empty_scene(20, earth, e), k);
    add_sphere(scene, 0.5, Vec3::Zero());
    scene.spheres[0].fixed = true;
    add_sphere(scene, 0.5, {0, 0, 1.25});
    Real time = 0, speed = 0, above = 0.25;
    do {
        const Landing down = landing(above, speed, k);
        time += down.time;
        speed = e * down.speed;
        above = 0;
    } while (speed > Real(1e-40));
    const Recorded run = record(scene);
    REQUIRE(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.counts.guarded == 0);
    REQUIRE(run.outcome.rest_times[1]);
    CHECK(std::abs(*run.outcome.rest_times[1] - static_cast<double>(time)) < 1e-7);
    CHECK(run.outcome.counts.impacts > 60);
    CHECK(run.outcome.max_penetration < 1e-15);
}

TEST_CASE("a ball with more than a million bounces to come rests by a threshold, and is named with what that took",
          "[drag]")
{
    for (const double e : {1.0, 1 - 1e-7}) {
        Scene scene = dropped(1e-6, 0.5, e, 1000);
        scene.rest.closing_speed = 0.01;
        const Recorded run = record(scene);
        const Outcome& out = run.outcome;
        REQUIRE(out.status == Status::reached_end);
        REQUIRE(out.early_rest);
        CHECK(out.early_rest->body == 0);
        CHECK(out.early_rest->time > 1);
        CHECK(out.early_rest->time < 1000);
        CHECK(out.energy_taken.settling == Approx(1e-6 * g).epsilon(1e-2));
        CHECK(out.counts.impacts == 1);
        REQUIRE(run.events.size() == 3);
        CHECK(run.events[1].kind == EventKind::settle);
        CHECK(run.events[1].impulse.z() == Approx(-std::sqrt(2 * g * 1e-6)).epsilon(1e-2));
        CHECK(run.events[2].kind == EventKind::rest);
    }
    CHECK_FALSE(record(dropped(1e-6, 0.5, 0.999, 5)).outcome.early_rest);
}

TEST_CASE("an elastic ball bounces on under drag where the end of the scene comes before a million bounces", "[drag]")
{
    // Without drag: a bounce every 2 w / g with w^2 = 2 g h. Drag takes 2 k w / 3 g of the speed of each.
    for (const double k : {1e-310, 1e-9, 0.5}) {
        Scene scene = dropped(1e-6, k, 1, 1);
        const Outcome out = record(scene).outcome;
        REQUIRE(out.status == Status::reached_end);
        CAPTURE(k);
        CHECK_FALSE(out.early_rest);
        const double w = std::sqrt(2 * g * 1e-6), grown = k / 3;
        const double bounces = g / (2 * w) * (grown > 1e-6 ? std::expm1(grown) / grown : 1);
        CHECK(static_cast<double>(out.counts.impacts) == Approx(bounces).epsilon(1e-2));
    }
}

TEST_CASE("a ball falls no faster than g/k, and at that speed in the end", "[drag]")
{
    Scene scene = damped(empty_scene(40, earth), 2);
    add_sphere(scene, 0.1, {0, 0, 1000}, {0, 0, 50});
    add_sphere(scene, 0.1, {5, 0, 1000}, {0, 0, -50});
    const Outcome out = record(scene).outcome;
    for (const BodyState& end : out.final) CHECK(end.velocity.z() == Approx(-g / 2).epsilon(1e-15));
    CHECK(out.final[0].position.z() == Approx(1000 + 50.0 / 2 - g * (40 - 0.5) / 2).epsilon(1e-15));
}

TEST_CASE("a ball that slides stops after v/k, on a level floor, and slides on at g sin/k on a slope", "[drag]")
{
    Scene scene = damped(empty_scene(60, earth, 0.5), 0.9);
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.1}, {3, 0, 0});
    const Outcome out = record(scene).outcome;
    CHECK(out.counts.impacts == 0);
    CHECK(out.final[0].position.x() == Approx(3 / 0.9).epsilon(1e-15));
    CHECK(out.final[0].velocity.x() < 1e-22);
    CHECK(out.plane_impulses[0] == Approx(60 * g).epsilon(1e-14));

    Scene slope = damped(empty_scene(60, earth, 0.5), 0.9);
    add_plane(slope, "slope", {0.6, 0, 0.8});
    add_sphere(slope, 0.1, 0.1 * Vec3(0.6, 0, 0.8));
    CHECK(record(slope).outcome.final[0].velocity.dot(Vec3(0.8, 0, -0.6)) == Approx(0.6 * g / 0.9).epsilon(1e-14));
}

TEST_CASE("without gravity drag is another clock: the same impacts, and kinetic energy falls as exp(-2 k t)", "[drag]")
{
    const double k = 0.4, end = 6;
    const Scene slow = damped(gas(3, 40, end, Vec3::Zero(), 1, 0.3, 0.5, 5), k);
    const Scene plain = gas(3, 40, (1 - std::exp(-k * end)) / k, Vec3::Zero(), 1, 0.3, 0.5, 5);
    const Recorded a = record(slow), b = record(plain);
    REQUIRE(a.outcome.status == Status::reached_end);
    REQUIRE(a.outcome.counts.impacts > 100);
    CHECK(a.outcome.kernel == "damped");
    CHECK(a.outcome.counts.impacts == b.outcome.counts.impacts);
    CHECK(partners(a.events, 60) == partners(b.events, 60));
    for (std::size_t i = 0; i < 30; ++i)
        CHECK((1 - std::exp(-k * a.events[i].time)) / k == Approx(b.events[i].time).epsilon(1e-9));
    const double before = kinetic_energy(slow, initial_states(slow));
    CHECK(kinetic_energy(slow, a.outcome.final) == Approx(before * std::exp(-2 * k * end)).epsilon(1e-11));
}

TEST_CASE("the energy that a flight under gravity loses is the work of drag", "[drag]")
{
    const double k = 0.7, end = 1.3;
    Scene scene = damped(empty_scene(end, earth), k);
    add_sphere(scene, 0.1, Vec3::Zero(), {4, -1, 6}, 2);
    add_sphere(scene, 0.1, {1, 1, 50}, {0, 3, 0}, 1);
    const Outcome out = record(scene).outcome;
    Real work = 0;
    for (const Sphere& s : scene.spheres) {
        // v = u + (v0 - u) exp(-k t), u = g/k; the integral of k m v^2.
        const Real decay = exp(-Real(k) * end), way = (1 - decay) / k;
        for (int i = 0; i < 3; ++i) {
            const Real u = Real(earth[i]) / k, d = Real(s.velocity[i]) - u;
            work += Real(k) * s.mass * (d * d * (1 - decay * decay) / (2 * Real(k)) + 2 * d * u * way + u * u * end);
        }
    }
    const double lost = energy(scene, initial_states(scene)) - energy(scene, out.final);
    CHECK(lost == Approx(static_cast<double>(work)).epsilon(1e-13));
}

TEST_CASE("grid and all pairs give the same run under drag, of gases that keep or lose energy, with gravity or without",
          "[drag]")
{
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
        for (const Vec3& gravity : {Vec3(Vec3::Zero()), earth})
            for (const double e : {1.0, 0.8})
                for (const double k : {0.05, 1.0}) {
                    const Scene scene = damped(gas(seed, 50, 3, gravity, e), k);
                    CAPTURE(seed, gravity.z(), e, k);
                    CHECK(hash_of(scene, BroadPhase::all_pairs) == hash_of(scene, BroadPhase::cell_grid));
                }
}

TEST_CASE("heaps come to rest under drag, whatever the rest policy and the impact operator", "[drag]")
{
    for (const RestPolicy policy : {RestPolicy::contact, RestPolicy::micro, RestPolicy::none})
        for (const ImpactOperator impact :
             {ImpactOperator::reflections, ImpactOperator::sequential, ImpactOperator::lcp, ImpactOperator::shock}) {
            // Policy micro is a train of bounces, 1e5 of them a second here.
            const bool is_dense = policy == RestPolicy::micro;
            Scene scene = damped(is_dense ? shaft(2, 5, 1) : shaft(2, 12, 3), 0.6);
            scene.rest.policy = policy;
            scene.impact.impact_operator = impact;
            const Outcome out = record(scene).outcome;
            CAPTURE(static_cast<int>(policy), static_cast<int>(impact), out.message);
            CHECK((out.status == Status::reached_end || (policy == RestPolicy::none && out.status == Status::zeno)));
            for (const BodyState& end : out.final) CHECK(end.position.z() > 0.027);
        }
}

TEST_CASE("windows of the guard are damped, whatever its fallback", "[drag]")
{
    for (const GuardFallback fallback : {GuardFallback::moreau, GuardFallback::pbd, GuardFallback::velocity}) {
        Scene scene = damped(shaft(3, 12, 1.5), 2);
        scene.guard.impacts = 2;
        scene.guard.fallback = fallback;
        const Outcome out = record(scene).outcome;
        CAPTURE(static_cast<int>(fallback), out.message);
        REQUIRE(out.status == Status::reached_end);
        CHECK(out.counts.guarded > 0);
        CHECK(out.max_penetration < 1e-8);
        CHECK(hash_of(scene, BroadPhase::all_pairs) == hash_of(scene, BroadPhase::cell_grid));
    }
}

TEST_CASE("a ball that rolls off a fixed one under drag follows the equation of its angle", "[drag]")
{
    const double k = 1.5, angle = 0.2;
    Scene scene = damped(empty_scene(0.4, earth, 0), k);
    add_sphere(scene, 0.5, Vec3::Zero());
    scene.spheres[0].fixed = true;
    add_sphere(scene, 0.5, {std::sin(angle), 0, std::cos(angle)});
    const Outcome out = record(scene).outcome;
    REQUIRE(out.status == Status::reached_end);
    REQUIRE(out.counts.releases == 0);
    // theta'' = g sin(theta) - k theta', by the midpoint rule extrapolated from 1,000 and 2,000 steps.
    const auto integrate = [&](int steps) {
        double theta = angle, rate = 0;
        const double h = scene.end_time / steps;
        for (int i = 0; i < steps; ++i) {
            const double theta_middle = theta + h / 2 * rate,
                         rate_middle = rate + h / 2 * (g * std::sin(theta) - k * rate);
            theta += h * rate_middle;
            rate += h * (g * std::sin(theta_middle) - k * rate_middle);
        }
        return theta;
    };
    const double theta = (4 * integrate(2000) - integrate(1000)) / 3;
    CHECK(std::atan2(out.final[1].position.x(), out.final[1].position.z()) == Approx(theta).epsilon(1e-7));
    CHECK(out.final[1].position.norm() == Approx(1).epsilon(1e-12));
    // What drag takes, 0.1, is its work and no error of the steps.
    CHECK(std::abs(out.energy_taken.stabilising) < 1e-6);
}

TEST_CASE("a scene without drag runs on the damped kernel with the bits of the general one", "[drag][kernels]")
{
    EventDriven general, forced;
    general.kernel = "general";
    forced.kernel = "damped";
    const Scene scene = gas(5, 30, 2, earth, 0.9);
    CHECK(record(scene, general).outcome.event_hash == record(scene, forced).outcome.event_hash);
    CHECK_THROWS_AS(record(damped(scene, 0.1), general), InputError);
    EventDriven certified;
    certified.certified = true;
    CHECK(record(scene, certified).outcome.kernel == "general");
    CHECK_THROWS_WITH(record(damped(scene, 0.1), certified), Catch::Contains("no drag yet"));
}

TEST_CASE("drag whose numbers leave the range of doubles is refused before the run", "[drag]")
{
    const Outcome out = record(dropped(1, 1e200, 0.5, 1)).outcome;
    CHECK(out.status == Status::unresolved);
    CHECK(out.message.find("drag") != std::string::npos);
}
