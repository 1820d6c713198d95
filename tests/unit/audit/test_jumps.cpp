#include "drop.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using audit::FindingKind;

TEST_CASE("a jump of places is invented, also while a body flies away from a plane, or was about to touch it")
{
    // Heights over the floor at 1/240 s and 4 m/s: near enough to touch it within the interval, or not at all.
    const double height = GENERATE(0.005, 0.5), speed = GENERATE(4.0, -4.0);
    CAPTURE(height, speed);
    Scene scene = empty_scene(1, earth);
    add_floor(scene);
    const double jump = 0.1 + 0.3 / rate;
    Path path{{0, {0, 0, 0}, {0, 0, speed - earth.z() * jump}}};
    path[0].place.z() = 0.1 + height - place_at(path, earth, jump).z();
    add_sphere(scene, 0.1, path[0].place, path[0].velocity);
    Path jumps = path;
    jumps.push_back({jump, place_at(path, earth, jump) + Vec3(0, 0, 0.3), {0, 0, speed}});
    Frames frames = frames_of({jumps}, earth, equal_times(rate, 0.13));
    const audit::TraceAudit result = audit::audit_trace(scene, frames);
    CHECK(result.invented == 1);
    CHECK(result.touches.missed + result.touches.late + result.touches.early == 0);
    REQUIRE_FALSE(result.findings.empty());
    CHECK(result.findings.front().kind == FindingKind::invented);
}

TEST_CASE("a change towards the one plane that a body may touch is invented, for contacts push")
{
    Scene scene = empty_scene(1);
    add_floor(scene);
    // It leaves the floor at 2 m/s, 1 mm above it, and turns back by itself within the interval.
    Path path{{0, {0, 0, 0.1 + 1e-3 - 2 * 10.3 / rate + 1}, {0, 0, 2}}};
    path[0].place.z() = 0.1 + 1e-3 - 2 * 10.3 / rate;
    add_sphere(scene, 0.1, path[0].place, path[0].velocity);
    turn(path, Vec3::Zero(), 10.5 / rate, {0, 0, 1});
    Frames frames = frames_of({path}, Vec3::Zero(), equal_times(rate, 0.1));
    frames.frames.erase(frames.frames.begin(), frames.frames.begin() + 7);  // before, it was inside the floor
    const audit::TraceAudit result = audit::audit_trace(scene, frames);
    CHECK(result.invented == 1);
}

TEST_CASE("a ball between two plates that it crosses within an interval has not jumped")
{
    Scene scene = empty_scene(1);
    add_plane(scene, "low", Vec3::UnitZ(), 0);
    add_plane(scene, "high", -Vec3::UnitZ(), -0.21);
    // A way of 0.01 to and fro: at 3 m/s a touch each 0.8 of an interval.
    Path path{{0, {0, 0, 0.1}, {0.1, 0, 3}}};
    add_sphere(scene, 0.1, path[0].place, path[0].velocity);
    for (int k = 1; k < 60; ++k) turn(path, Vec3::Zero(), k * 0.01 / 3, {0.1, 0, k % 2 == 1 ? -3.0 : 3.0});
    Frames frames = frames_of({path}, Vec3::Zero(), equal_times(rate, 0.19));
    CHECK(audit::audit_trace(scene, frames).found_wrong() == 0);
}
