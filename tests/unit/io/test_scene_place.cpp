#include <catch2/catch.hpp>

#include "problems_of.hpp"

using namespace carom;
using namespace carom::test;
using Catch::StartsWith;

TEST_CASE("origin and start time are kept as written, and nothing is moved by them", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("origin": [1e9, -2, 0.5], "start_time": {"epoch": 1024, "offset": 0.25},
        "spheres": [{"radius": 1, "position": [0.1, 0, 1]}], "planes": [{"normal": [0, 0, 1], "offset": 0}])"),
                                "s.json");
    CHECK(s.origin == Vec3(1e9, -2, 0.5));
    CHECK(s.start_time.epoch == 1024);
    CHECK(s.start_time.offset == 0.25);
    CHECK(s.spheres[0].position == Vec3(0.1, 0, 1));
    CHECK(s.planes[0].offset == 0);
}

TEST_CASE("a start time may be a number, then it is the offset", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("start_time": -1099511627776.5)"), "s.json");
    CHECK(s.start_time.epoch == 0);
    CHECK(s.start_time.offset == -1099511627776.5);
    CHECK(parse_scene(scene_with(R"("start_time": {"epoch": 7})"), "s.json").start_time == EpochTime{7, 0});
}

TEST_CASE("what is wrong with a start time is said at its place", "[io]")
{
    CHECK_THAT(problem_with(R"("start_time": "noon")"), StartsWith("s.json: /start_time: must be a number"));
    CHECK_THAT(problem_with(R"("start_time": {"offset": 1})"), StartsWith("s.json: /start_time/epoch: is missing"));
    CHECK_THAT(problem_with(R"("start_time": {"epoch": 1.5})"), StartsWith("s.json: /start_time/epoch: must be an in"));
    CHECK_THAT(problem_with(R"("start_time": {"epoch": 1, "ofset": 2})"),
               StartsWith("s.json: /start_time/ofset: unknown key (did you mean \"offset\"?)"));
}

TEST_CASE("overlap is found relative to the origin: far away it is as exact as near", "[io]")
{
    // At 1e9 the gap of 1e-10 would be lost in absolute coordinates, and so would the overlap of 1e-8.
    const std::string far = R"("origin": [1e9, 1e9, 1e9], "spheres": [{"radius": 0.001, "position": [0, 0, 0]},
        {"radius": 0.001, "position": [0, 0, )";
    CHECK(problems_of(scene_with(far + "0.0020000001]}]")).empty());
    CHECK_THAT(problem_with(far + "0.00199999]}]"), Catch::Contains("overlaps sphere"));
}

TEST_CASE("a fixed sphere is fixed, and must not move", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0], "fixed": true}],
        "fill": [{"pattern": "line", "count": 2, "radius": 1, "origin": [5, 0, 0], "fixed": true},
                 {"pattern": "line", "count": 1, "radius": 1, "origin": [50, 0, 0], "fixed": false, "speed": 1}])"),
                                "s.json");
    CHECK(s.spheres[0].fixed);
    CHECK(s.spheres[1].fixed);
    CHECK(s.spheres[2].fixed);
    CHECK_FALSE(s.spheres[3].fixed);
    CHECK_THAT(
        problem_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0], "velocity": [0, 0, 1e-300], "fixed": true}])"),
        StartsWith("s.json: /spheres/0/velocity: must be 0"));
    CHECK_THAT(problem_with(R"("fill": [{"pattern": "line", "count": 2, "radius": 1, "fixed": true, "speed": 1}])"),
               StartsWith("s.json: /fill/0/speed: must be 0"));
    CHECK_THAT(problem_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0], "fixed": 1}])"),
               StartsWith("s.json: /spheres/0/fixed: must be true or false, is the number 1"));
}
