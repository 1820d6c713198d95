// A sphere that touches nothing but another one, or two: its bounces go on until rounding ends them, thresholds are for
// heaps.
#include "support/multiprecision.hpp"
#include "support/recorded.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;
using Real = Float<50>;

namespace {

constexpr double g = 9.81, r = 0.1;

/// A ball above a fixed one, `gap` over their contact at x beside the axis.
Scene ball_on_ball(double restitution, double gap, double x = 0)
{
    Scene scene = empty_scene(3, earth, restitution);
    add_sphere(scene, r, Vec3::Zero());
    scene.spheres[0].fixed = true;
    add_sphere(scene, r, {x, 0, std::sqrt(4 * r * r - x * x) + gap});
    return scene;
}

std::optional<double> time_of_rest(const Recorded& run)
{
    for (const Event& e : run.events)
        if (e.kind == EventKind::rest) return e.time;
    return {};
}

void check_held_by_nothing(const Scene& scene, const Recorded& run)
{
    CHECK(run.outcome.status == Status::reached_end);
    CHECK(run.outcome.counts.guarded == 0);
    CHECK(std::abs(run.outcome.energy_taken.closing) < 1e-25);
    CHECK_FALSE(run.outcome.early_rest);
    MemorySource source = recorded(scene);
    CHECK(verify(source).violations.empty());
}

/// Point on a circle, bounce by bounce in 50 digits, until its normal speed is 1e-30 of the first.
struct Bounces {
    Real time = 0, x, z, vx = 0, vz = 0;
    std::vector<Real> impacts;

    Bounces(double x0, double z0, double restitution) : x(x0), z(z0)
    {
        const Real s2 = 4 * Real(r) * Real(r), e = restitution, pull = g;
        Real first = 0;
        for (;;) {
            const Real c0 = 2 * (x * vx + z * vz), c1 = vx * vx + vz * vz - z * pull, c2 = -vz * pull,
                       c3 = pull * pull / 4, gap = x * x + z * z - s2;
            const bool falls = impacts.empty();
            Real t = falls ? Real(sqrt(gap / (z * pull))) : Real(-c0 / c1);
            for (int i = 0; i < 30; ++i) {
                const Real f = c0 + t * (c1 + t * (c2 + t * c3)), df = c1 + t * (2 * c2 + 3 * t * c3);
                t -= falls ? (gap + t * f) / (f + t * df) : f / df;
            }
            time += t;
            x += t * vx;
            z += t * (vz - t * pull / 2);
            vz -= t * pull;
            impacts.push_back(time);
            const Real size = sqrt(x * x + z * z), nx = x / size, nz = z / size, w = nx * vx + nz * vz;
            if (falls) first = w;
            vx -= (1 + e) * w * nx;
            vz -= (1 + e) * w * nz;
            if (w / first < Real(1e-30)) return;
        }
    }
};

double off(double value, const Real& exact)
{
    return std::abs(static_cast<double>(Real(value) - exact));
}

}  // namespace

TEST_CASE("a ball on a fixed ball rests when infinitely many bounces are over")
{
    for (const double e : {0.5, 0.8, 0.9, 0.99, 0.999}) {
        const Scene scene = ball_on_ball(e, 1e-5);
        const Recorded run = record(scene);
        const Real height = Real(scene.spheres[1].position.z()) - 2 * Real(r);
        const Real exact = sqrt(2 * height / g) * (1 + Real(e)) / (1 - Real(e));
        CAPTURE(e, run.events.size());
        REQUIRE(run.outcome.rest_times[1]);
        CHECK(off(*run.outcome.rest_times[1], exact) < 1e-10);
        if (e < 0.95) CHECK(off(*run.outcome.rest_times[1], exact) < 1e-14);
        CHECK(run.outcome.final[1].mode == Mode::resting);
        check_held_by_nothing(scene, run);
    }
}

TEST_CASE("so does one that is dropped lower than what thresholds take for nothing")
{
    const Scene scene = ball_on_ball(0.9, 1e-9);  // v_c rises to 1e-6
    const Recorded run = record(scene);
    const Real height = Real(scene.spheres[1].position.z()) - 2 * Real(r);
    REQUIRE(run.outcome.rest_times[1]);
    CHECK(off(*run.outcome.rest_times[1], sqrt(2 * height / g) * 19) < 1e-12);
    check_held_by_nothing(scene, run);
}

TEST_CASE("off the axis it bounces while it slides, as 50 digits have it")
{
    for (const double e : {0.5, 0.9, 0.99})
        for (const double x : {1e-3, 1e-2}) {
            Scene scene = ball_on_ball(e, 1e-5, x);
            const Bounces exact(scene.spheres[1].position.x(), scene.spheres[1].position.z(), e);
            const double end = exact.time.convert_to<double>();
            scene.end_time = end;
            const Recorded run = record(scene);
            CAPTURE(e, x);
            REQUIRE(time_of_rest(run));
            CHECK(off(*time_of_rest(run), exact.time) < 1e-12);
            for (std::size_t k = 0; k + 1 < run.events.size(); ++k) {
                CAPTURE(k);
                REQUIRE(run.events[k].kind == EventKind::impact);
                CHECK(off(run.events[k].time, exact.impacts[k]) < 1e-12);
            }
            const BodyState& ball = run.outcome.final[1];
            CHECK(off(ball.position.x(), exact.x) < 1e-12);
            CHECK(off(ball.position.z(), exact.z) < 1e-12);
            CHECK(off(ball.velocity.x(), exact.vx) < 1e-12);
            check_held_by_nothing(scene, run);
        }
}

TEST_CASE("where it lies, how large it is and what a user makes of the thresholds is all the same")
{
    const auto rest = [](const Scene& scene) { return *record(scene).outcome.rest_times[1]; };
    const Scene scene = ball_on_ball(0.9, 1e-5);
    const double exact = std::sqrt(2 * (scene.spheres[1].position.z() - 2 * r) / g) * 19;
    CHECK(rest(scene) == Approx(exact).epsilon(1e-10));
    for (const double v_c : {1e-9, 0.01, 1.0}) {
        Scene other = scene;
        other.rest.closing_speed = v_c;
        CHECK(rest(other) == rest(scene));
    }
    Scene guarded = scene;
    guarded.guard.impacts = 1;
    CHECK(rest(guarded) == rest(scene));
    Scene large = scene;
    for (Sphere& s : large.spheres) {
        s.radius *= 1024;
        s.position *= 1024;
    }
    large.gravity *= 1024;
    large.end_time = scene.end_time;
    CHECK(rest(large) == Approx(exact).epsilon(1e-10));
    Scene far = scene;
    for (Sphere& s : far.spheres) s.position += Vec3(1000, 2000, 1024);
    CHECK(rest(far) == Approx(exact).epsilon(1e-7));  // its gap is known to 2e-13
    CHECK(simulate(scene, EventDriven{.certified = true}).rest_times[1].value() == Approx(exact).epsilon(1e-10));
}

TEST_CASE("where a million bounces are to come a threshold ends them, and the outcome says by how much too early")
{
    const double e = 1 - 1e-5;
    Scene scene = ball_on_ball(e, 1e-7);  // lower than what v_c rises to
    scene.spheres[1].id = "ball";
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.counts.early_rests == 1);
    REQUIRE(outcome.early_rest);
    CHECK(scene.body_name(outcome.early_rest->body) == "ball");
    REQUIRE(outcome.rest_times[1]);
    const double height = scene.spheres[1].position.z() - 2 * r;
    const double exact = std::sqrt(2 * height / g) * (1 + e) / (1 - e);
    CHECK(*outcome.rest_times[1] + outcome.early_rest->time == Approx(exact).epsilon(1e-9));
}

TEST_CASE("two spheres that fly and touch nothing else rebound, however slowly they meet")
{
    for (const Vec3& gravity : {earth, Vec3(0, 0, 0)}) {
        Scene scene = empty_scene(2, gravity, 0.5);
        add_sphere(scene, r, {0, 0, 0}, {1, 0, 0});
        add_sphere(scene, r, {2 * r + 1e-8, 0, 0}, {1 - 1e-7, 0, 0}, 3);
        const Recorded run = record(scene);
        REQUIRE(run.events.size() == 1);
        const double apart = run.outcome.final[1].velocity.x() - run.outcome.final[0].velocity.x();
        CHECK(apart == Approx(0.5e-7).epsilon(1e-6));
        CHECK(run.outcome.counts.rests == 0);
        check_held_by_nothing(scene, run);
    }
}

TEST_CASE("a sphere that falls between two fixed ones, on both at once, rests when its bounces are over")
{
    for (const double e : {0.5, 0.8, 0.9, 0.95}) {
        Scene scene = empty_scene(3, earth, e);
        for (const double side : {-r, r}) {
            add_sphere(scene, r, {side, 0, 0});
            scene.spheres.back().fixed = true;
        }
        add_sphere(scene, r, {0, 0, std::sqrt(3.0) * r + 2e-5});
        const Outcome outcome = simulate(scene, EventDriven{});
        const Real height = Real(scene.spheres[2].position.z()) - sqrt(Real(3)) * Real(r);
        const Real exact = sqrt(2 * height / g) * (1 + Real(e)) / (1 - Real(e));
        CAPTURE(e);
        REQUIRE(outcome.rest_times[2]);
        // Its last rebound opens both contacts, along normals that are 30 degrees off the vertical, no faster than what
        // rises to 16 u of 0.35, radius and cell.
        const double last = std::sqrt(2 * g * 0x1p-49 * 0.35) / std::cos(std::asin(0.5));
        CHECK(off(*outcome.rest_times[2], exact) < 2 * last / (g * (1 - e)));
        CHECK(outcome.energy_taken.settling + outcome.energy_taken.closing < 1e-13);
        CHECK(outcome.counts.guarded == 0);
        CHECK_FALSE(outcome.early_rest);
    }
}

TEST_CASE("where a million bounces on two spheres are to come thresholds end them, and the outcome names the body")
{
    Scene scene = empty_scene(3, earth, 1 - 1e-5);
    for (const double side : {-r, r}) {
        add_sphere(scene, r, {side, 0, 0});
        scene.spheres.back().fixed = true;
    }
    add_sphere(scene, r, {0, 0, std::sqrt(3.0) * r + 1e-7});  // lower than what v_c rises to
    scene.spheres.back().id = "ball";
    const Outcome outcome = simulate(scene, EventDriven{});
    CHECK(outcome.status == Status::reached_end);
    CHECK(outcome.counts.early_rests == 1);
    REQUIRE(outcome.early_rest);
    CHECK(scene.body_name(outcome.early_rest->body) == "ball");
    REQUIRE(outcome.rest_times[2]);
    CHECK(*outcome.rest_times[2] < 0.01);
}
