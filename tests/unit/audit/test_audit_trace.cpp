#include "audit/minimal_scene.hpp"
#include "drop.hpp"
#include "support/random.hpp"

#include <carom/checks.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace carom;
using namespace carom::test;
using audit::FindingKind;

namespace {

/// Two spheres of radius 0.5 that meet at t = 1, at x = -0.5 and 0.5, with speeds 1.
struct Meeting {
    Scene scene = empty_scene(2);
    Path a{{0, {-1.5, 0, 0}, Vec3::UnitX()}}, b{{0, {1.5, 0, 0}, -Vec3::UnitX()}};

    Meeting()
    {
        add_sphere(scene, 0.5, a[0].place, a[0].velocity);
        add_sphere(scene, 0.5, b[0].place, b[0].velocity);
    }
    audit::TraceAudit audited() const
    {
        Frames frames = frames_of({a, b}, Vec3::Zero(), equal_times(rate, 2));
        return audit::audit_trace(scene, frames);
    }
};

}  // namespace

TEST_CASE("an exact bounce is found, and nothing else")
{
    Drop drop;
    drop.bounce_at(drop.touch);
    const audit::TraceAudit result = drop.audited();
    CHECK(result.touches.found == 1);
    CHECK(result.found_wrong() == 0);
    CHECK(result.undecided() == 0);
    // The two intervals behind the bounce have no flight of three frames before them.
    CHECK(result.bodies.without_flight == 2);
    CHECK(result.bodies.decided == result.bodies.all - 2);
}

TEST_CASE("a deleted bounce is missed at the time of the touch, and the overlap that follows is told")
{
    const audit::TraceAudit result = Drop().audited();
    REQUIRE(result.touches.missed == 1);
    CHECK(result.found_wrong() == 2);
    CHECK(result.overlaps == 1);
    const audit::Finding& finding = result.findings.front();
    CHECK(finding.kind == FindingKind::missed);
    CHECK(finding.time == Approx(std::sqrt(2 / 9.81)).epsilon(1e-11));
    CHECK(result.deepest == Approx(9.81 * 0.8 * 0.8 / 2 - 1).epsilon(1e-2));
}

TEST_CASE("a bounce that is shifted is late by that much, within one interval and over several")
{
    const double delay = GENERATE(0.3 / rate, 1.0 / rate, 2.7 / rate, 1e-6);
    CAPTURE(delay);
    Drop drop;
    drop.bounce_at(drop.touch + delay);
    const audit::TraceAudit result = drop.audited();
    REQUIRE(result.touches.late == 1);
    CHECK(result.touches.missed + result.touches.early + result.invented == 0);
    CHECK(result.findings.front().kind == FindingKind::late);
    CHECK(result.findings.front().by == Approx(delay).margin(1e-11));
    CHECK(result.findings.front().depth ==
          Approx(drop.speed * delay + 9.81 * delay * delay / 2).epsilon(1e-4).margin(1e-12));
}

TEST_CASE("a bounce before the touch is early by that much")
{
    const double advance = 0.2 / rate;
    Drop drop;
    drop.touch -= 0.4 / rate;  // so that both times are in one interval
    drop.path[0].velocity.z() = (drop.touch * drop.touch * 9.81 / 2 - 1) / drop.touch;
    drop.scene.spheres[0].velocity = drop.path[0].velocity;
    drop.bounce_at(drop.touch - advance);
    const audit::TraceAudit result = drop.audited();
    CHECK(result.found_wrong() == 1);
    REQUIRE(result.touches.early == 1);
    CHECK(result.findings.front().by == Approx(advance).margin(1e-11));
}

TEST_CASE("a change of velocity where nothing touches is invented")
{
    const double when = GENERATE(0.2511, 60 / rate);  // within an interval, and at a frame
    Drop drop;
    turn(drop.path, earth, when, {1, 0, -9.81 * when});
    const audit::TraceAudit result = drop.audited(equal_times(rate, 0.4));
    REQUIRE(result.invented == 1);
    CHECK(result.found_wrong() == 1);
    const audit::Finding& finding = result.findings.front();
    CHECK(finding.time == Approx(when).margin(1e-11));
    CHECK(finding.change == Approx(1).epsilon(1e-9));
    CHECK(finding.b == no_body);
}

TEST_CASE("a ball that is through a plate has missed it, however thin and quick")
{
    const double speed = GENERATE(1.0, 1e3);
    Scene scene = empty_scene(1);
    add_plane(scene, "plate", Vec3::UnitX());
    scene.planes[0].thickness = 1e-3;
    add_sphere(scene, 0.05, {-speed / 10, 0, 0}, {speed, 0, 0});
    Frames frames =
        frames_of({{{0, scene.spheres[0].position, scene.spheres[0].velocity}}}, Vec3::Zero(), equal_times(rate, 0.5));
    const audit::TraceAudit result = audit::audit_trace(scene, frames);
    REQUIRE(result.touches.missed == 1);
    CHECK(result.touches.all == 1);
    CHECK(result.findings[0].time == Approx(0.1 - 0.0505 / speed).epsilon(1e-9));
}

TEST_CASE("a change of the side of a plate is a miss even where no flight is known before")
{
    Scene scene = empty_scene(1);
    add_plane(scene, "plate", Vec3::UnitX());
    scene.planes[0].thickness = 1e-3;
    add_sphere(scene, 0.05, {2, 0, 0});
    Frames frames;
    for (int k = 0; k < 8; ++k) frames.frames.push_back({k / rate, {{1 - 0.01 * k * k * k, 0, 0}}});
    const audit::TraceAudit result = audit::audit_trace(scene, frames);
    CHECK(result.touches.missed == 1);
    CHECK(result.findings.front().time == Approx(4.6 / rate).margin(0.5 / rate));
}

TEST_CASE("walls of a box, fixed spheres and spheres that move are missed alike")
{
    SECTION("a wall")
    {
        Scene scene = empty_scene(2);
        add_box(scene, 2);
        add_sphere(scene, 0.25, {1, 1, 1}, {2, 0, 0});
        Frames frames = frames_of({{{0, {1, 1, 1}, {2, 0, 0}}}}, Vec3::Zero(), equal_times(rate, 1));
        const audit::TraceAudit result = audit::audit_trace(scene, frames);
        CHECK(result.touches.missed == 1);
        CHECK(result.findings.front().time == Approx(0.375).epsilon(1e-12));
    }
    SECTION("a fixed sphere under gravity")
    {
        Scene scene = empty_scene(1, earth);
        add_sphere(scene, 0.1, {0, 0, 1.2});
        add_sphere(scene, 0.1, {0, 0, 0});
        scene.spheres[1].fixed = true;
        Frames frames = frames_of({{{0, {0, 0, 1.2}, Vec3::Zero()}}, {{0, Vec3::Zero(), Vec3::Zero()}}}, earth,
                                  equal_times(rate, 1));
        for (audit::Frame& frame : frames.frames) frame.places[1].setZero();
        const audit::TraceAudit result = audit::audit_trace(scene, frames);
        CHECK(result.touches.missed == 1);
        CHECK(result.findings.front().time == Approx(std::sqrt(2 / 9.81)).epsilon(1e-11));
    }
    SECTION("a sphere")
    {
        const audit::TraceAudit result = Meeting().audited();
        CHECK(result.touches.missed == 1);
        CHECK(result.findings.front().time == Approx(1).epsilon(1e-11));
        CHECK(result.overlaps == 1);
        CHECK(result.deepest == Approx(1).epsilon(1e-9));  // frame 1.5 shows them at one place
    }
}

TEST_CASE("two spheres that exchange their velocities in time are found, later ones are late")
{
    const double delay = GENERATE(0.0, 0.4 / rate, 3.3 / rate);
    Meeting meeting;
    turn(meeting.a, Vec3::Zero(), 1 + delay, -Vec3::UnitX());
    turn(meeting.b, Vec3::Zero(), 1 + delay, Vec3::UnitX());
    const audit::TraceAudit result = meeting.audited();
    CHECK(result.touches.found == (delay > 0 ? 0 : 1));
    REQUIRE(result.touches.late == (delay > 0 ? 1 : 0));
    if (delay > 0) CHECK(result.findings.front().by == Approx(delay).margin(1e-11));
    CHECK(result.touches.missed + result.invented == 0);
}

TEST_CASE("three balls in a row that meet within one interval are undecided, not wrong")
{
    Scene scene = empty_scene(1);
    Path a{{0, {-1, 0, 0}, {2, 0, 0}}}, b{{0, {0.001, 0, 0}, Vec3::Zero()}}, c{{0, {1.002, 0, 0}, Vec3::Zero()}};
    for (const Path* path : {&a, &b, &c}) add_sphere(scene, 0.5, (*path)[0].place, (*path)[0].velocity);
    turn(a, Vec3::Zero(), 0.0005, Vec3::Zero());
    turn(b, Vec3::Zero(), 0.0005, {2, 0, 0});
    turn(b, Vec3::Zero(), 0.001, Vec3::Zero());
    turn(c, Vec3::Zero(), 0.001, {2, 0, 0});
    Frames frames = frames_of({a, b, c}, Vec3::Zero(), equal_times(rate, 0.5));
    const audit::TraceAudit result = audit::audit_trace(scene, frames);
    CHECK(result.found_wrong() == 0);
    CHECK(result.bodies.several > 0);
}

TEST_CASE("frames need not be at equal distances")
{
    Drop drop;
    drop.bounce_at(drop.touch + 0.002);
    Random random(7);
    std::vector<double> times{0};
    while (times.back() < 0.8) times.push_back(times.back() + random.uniform(0.001, 0.006));
    const audit::TraceAudit result = drop.audited(times);
    REQUIRE(result.touches.late == 1);
    CHECK(result.findings.front().by == Approx(0.002).margin(1e-9));
    CHECK(result.found_wrong() == 1 + result.overlaps);
}

TEST_CASE("errors of printed digits make no findings, and where they hide the answer nothing is decided")
{
    const int decimals = GENERATE(8, 5, 3, 1);
    CAPTURE(decimals);
    Drop drop;
    drop.bounce_at(drop.touch);
    Frames frames = frames_of({drop.path}, earth, equal_times(rate, 0.8));
    const double unit = std::pow(10, -decimals);
    for (audit::Frame& frame : frames.frames)
        for (double& x : frame.places[0]) x = std::round(x / unit) * unit;
    audit::TraceRounding rounding;
    rounding.places.see("1." + std::string(static_cast<std::size_t>(decimals), '1'));
    frames.rounding() = rounding;
    const audit::TraceAudit result = audit::audit_trace(drop.scene, frames);
    CHECK(result.found_wrong() == 0);
    CHECK(result.touches.found == (decimals == 1 ? 0 : 1));
    CHECK(result.says_something() == (decimals != 1));
}

TEST_CASE("the scene of a finding shows the contact to the event method at the time that the audit says")
{
    Drop drop;
    drop.bounce_at(drop.touch + 0.003);
    const audit::TraceAudit result = drop.audited();
    REQUIRE(result.touches.late == 1);
    const Scene small = audit::minimal_scene(drop.scene, result.findings.front());
    CHECK(validate(small).empty());
    CHECK(small.spheres.size() == 1);
    const CheckReport checks = check_scene(small);
    REQUIRE(checks.results.size() == 1);
    CHECK(checks.results.front().verdict == CheckVerdict::holds);
}

TEST_CASE("a trace of bodies in lasting contact decides nothing")
{
    Scene scene = empty_scene(1, earth, 0);
    add_floor(scene);
    add_sphere(scene, 0.1, {0, 0, 0.1});
    Frames frames;
    for (const double t : equal_times(rate, 0.5)) frames.frames.push_back({t, {{0, 0, 0.1}}});
    const audit::TraceAudit result = audit::audit_trace(scene, frames);
    CHECK(result.found_wrong() == 0);
    CHECK(result.bodies.without_flight >= result.bodies.all - 2);
}
