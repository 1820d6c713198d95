#include <catch2/catch.hpp>

#include "problems_of.hpp"

using namespace carom;
using namespace carom::test;
using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("a slip in a key is reported with the key that was probably meant", "[io]")
{
    CHECK(problem_with(R"("planes": [{"normal": [0, 0, 1], "offset": 0, "ofset": 0}])") ==
          "s.json: /planes/0/ofset: unknown key (did you mean \"offset\"?)");
    CHECK(problem_with(R"("gravitiy": [0, 0, 0])") == "s.json: /gravitiy: unknown key (did you mean \"gravity\"?)");
    CHECK(problem_with(R"("Seed": 1)") == "s.json: /Seed: unknown key (did you mean \"seed\"?)");
    CHECK_THAT(problem_with(R"("materials": {"m": {"bounciness": 1}})"),
               StartsWith("s.json: /materials/m/bounciness: unknown key (known here: restitution, tangential"));
    CHECK_THAT(problem_with(R"("compare": {"method": ["event"]})"),
               StartsWith("s.json: /compare/method: unknown key (did you mean \"methods\"?)"));
    CHECK_THAT(problem_with(R"("spheres": [{"radius": 1, "position": [0,0,0], "material": "rubbr"}],
        "materials": {"rubber": {}})"),
               Contains("unknown material \"rubbr\" (did you mean \"rubber\"?)"));
    CHECK_THAT(problem_with(R"("checks": [{"type": "enrgy"}])"),
               StartsWith("s.json: /checks/0/type: \"enrgy\": unknown (did you mean \"energy\"?)"));
}

TEST_CASE("words that people try come with the right ones", "[io]")
{
    CHECK(problem_with(R"("planes": [{"normal": [0, 0, 1], "offset": 0, "angle": 26.6}])") ==
          "s.json: /planes/0/angle: unknown key (for a slope of a degrees write \"normal\": [sin a, 0, cos a] as "
          "numbers)");
    CHECK_THAT(problem_with(R"("materials": {"m": {"friction": 0.3}})"),
               StartsWith("s.json: /materials/m/friction: unknown key (there is no friction; \"tangential\""));
    const std::string ball = R"("spheres": [{"id": "y", "radius": 1, "position": [0, 0, 0]}], "checks": )";
    CHECK(problem_with(ball + R"([{"type": "rest_time", "body": "y", "sphere": "y", "time": 1}])") ==
          "s.json: /checks/0/sphere: unknown key (did you mean \"body\"?)");
    CHECK_THAT(problem_with(ball + R"([{"type": "rest_time", "body": "y", "time": 1, "value": 1}])"),
               Contains("/checks/0/value: unknown key (did you mean \"time\"?)"));
    CHECK_THAT(problem_with(ball + R"([{"type": "final_position", "body": "y", "value": [0, 0, 0], "position": 1}])"),
               Contains("/checks/0/position: unknown key (did you mean \"value\"?)"));
    // None of them is offered for a slip of another kind.
    CHECK_THAT(problem_with(R"("planes": [{"normal": [0, 0, 1], "offset": 0, "xyz": 1}])"), !Contains("angle"));
}

TEST_CASE("a sphere behind a plane is asked about the normal", "[io]")
{
    const std::string members = R"("spheres": [{"id": "a", "radius": 1, "position": [0, 0, -2]}],
        "planes": [{"id": "floor", "normal": [0, 0, 1], "offset": 0}])";
    CHECK(problem_with(members) ==
          "s.json: /spheres/0: sphere \"a\" is behind plane \"floor\" (/planes/0), overlapping by 3 (does the plane's "
          "normal point to the free side? else move one by at least 3.003, or pass --allow-overlap)");
}

TEST_CASE("a value of the wrong type is reported with what was expected and found", "[io]")
{
    CHECK(problem_with(R"("spheres": [{"radius": "big", "position": [0, 0, 0]}])") ==
          "s.json: /spheres/0/radius: must be a number, is the string \"big\"");
    CHECK(problem_with(R"("gravity": 9.81)") == "s.json: /gravity: must be a list of 3 numbers, is the number 9.81");
    CHECK(problem_with(R"("gravity": [0, 1])") == "s.json: /gravity: must be a list of 3 numbers, is a list of 2");
    CHECK(problem_with(R"("gravity": [0, null, 1])") == "s.json: /gravity/1: must be a number, is null");
    CHECK(problem_with(R"("spheres": {})") == "s.json: /spheres: must be a list, is an object");
    CHECK(problem_with(R"("spheres": [3])") == "s.json: /spheres/0: must be an object, is the number 3");
    CHECK(problem_with(R"("name": true)") == "s.json: /name: must be a string, is true");
    CHECK_THAT(problem_with(R"("seed": 1.5)"), StartsWith("s.json: /seed: must be an integer from 0 to"));
    CHECK_THAT(problem_with(R"("seed": -1)"), StartsWith("s.json: /seed: must be an integer from 0 to"));
    CHECK(problems_of("[1]") == std::vector<std::string>{"s.json: /: must be an object, is a list of 1"});
}

TEST_CASE("a value out of range is reported with its range", "[io]")
{
    CHECK(problem_with(R"("spheres": [{"radius": -1, "position": [0, 0, 0]}])") ==
          "s.json: /spheres/0/radius: must be > 0, is -1");
    CHECK(problem_with(R"("spheres": [{"radius": 1, "mass": 0, "position": [0, 0, 0]}])") ==
          "s.json: /spheres/0/mass: must be > 0, is 0");
    CHECK(problem_with(R"("materials": {"m": {"restitution": 1.1}})") ==
          "s.json: /materials/m/restitution: must be between 0 and 1, is 1.1");
    CHECK_THAT(problem_with(R"("planes": [{"normal": [0, 0, 0], "offset": 0}])"),
               StartsWith("s.json: /planes/0/normal: must have a direction"));
    CHECK_THAT(problem_with(R"("box": {"min": [0, 0, 0], "max": [1, 1, 0]})"),
               StartsWith("s.json: /box/max: must be greater than \"min\""));
    CHECK_THAT(problem_with(R"("spheres": [{"radius": 1e-200, "density": 1, "position": [0, 0, 0]}])"),
               StartsWith("s.json: /spheres/0/mass: must be finite and > 0"));
    CHECK_THAT(problem_with(R"("spheres": [{"id": "a,b", "radius": 1, "position": [0, 0, 0]}])"),
               StartsWith("s.json: /spheres/0/id: must be a name"));
    CHECK_THAT(problem_with(R"("materials": {"m": {"color": "red;}</style>"}})"),
               StartsWith("s.json: /materials/m/color: must be a CSS colour"));
}

TEST_CASE("keys that are missing, or that exclude each other, are reported", "[io]")
{
    CHECK(problems_of("{}").size() == 2);
    CHECK_THAT(problems_of("{}").front(), StartsWith("s.json: /format: is missing"));
    CHECK_THAT(problems_of(R"({"format": "carom-scene/2", "end_time": 1})").front(),
               StartsWith("s.json: /format: \"carom-scene/2\": unknown"));
    CHECK_THAT(problem_with(R"("spheres": [{"radius": 1}])"), StartsWith("s.json: /spheres/0/position: is missing"));
    CHECK_THAT(problem_with(R"("planes": [{"normal": [0, 0, 1]}])"),
               StartsWith("s.json: /planes/0: has none of \"offset\", \"point\""));
    CHECK_THAT(problem_with(R"("planes": [{"normal": [0, 0, 1], "offset": 0, "point": [0, 0, 0]}])"),
               StartsWith("s.json: /planes/0: has more than one of \"offset\", \"point\""));
    CHECK_THAT(problem_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0], "mass": 1, "density": 1}])"),
               StartsWith("s.json: /spheres/0: has more than one of \"mass\", \"density\""));
    CHECK_THAT(problem_with(R"("checks": [{"type": "energy", "abs": 1, "rel": 1}])"),
               StartsWith("s.json: /checks/0: has more than one of \"abs\", \"rel\""));
    CHECK_THAT(problem_with(R"("checks": [{"type": "event_time", "time": 1}])"),
               StartsWith("s.json: /checks/0/event: is missing"));
    CHECK_THAT(problem_with(R"("checks": [{"type": "rest_time", "time": 1, "body": "x"}],
        "spheres": [{"id": "y", "radius": 1, "position": [0, 0, 0]}])"),
               StartsWith("s.json: /checks/0/body: no sphere has the id \"x\""));
}

TEST_CASE("what a later version will read is refused as not yet supported, at its pointer", "[io]")
{
    const std::vector<std::pair<std::string, std::string>> later{
        {R"("obstacles": [])", "/obstacles"},
        {R"("state": {})", "/state"},
        {R"("box": {"min": [0, 0, 0], "max": [1, 1, 1], "walls": "periodic"})", "/box/walls"},
        {R"("box": {"min": [0, 0, 0], "max": [1, 1, 1], "walls": ["solid", "periodic", "solid"]})", "/box/walls/1"},
        {R"("box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "fill": [{"pattern": "fcc", "count": 4, "radius": 0.1}])",
         "/fill/0/pattern"},
        {R"("fill": [{"pattern": "line", "count": 4, "radius": 0.1, "temperature": 1}])", "/fill/0/temperature"},
        {R"("run": {"equilibrate": 1})", "/run/equilibrate"},
    };
    for (const auto& [members, pointer] : later) {
        INFO(members);
        CHECK_THAT(problem_with(members), StartsWith("s.json: " + pointer + ": ") && Contains("not yet supported"));
    }
}

TEST_CASE("all problems of a file are reported at once", "[io]")
{
    const auto problems = problems_of(R"({"format": "carom-scene/1", "end_time": -5, "gravty": [0, 0, -9.81],
        "spheres": [{"radius": 0, "position": [0, 0, 0]}, {"radius": 1, "position": [0, 0]},
                    {"id": "a", "radius": 1, "position": [9, 0, 0]}, {"id": "b", "radius": 1, "position": [10, 0, 0]}],
        "planes": [{"normal": "up", "offset": 0}], "checks": [{"type": "rest_time", "body": "sphere-0", "time": 1}]})");
    REQUIRE(problems.size() == 6);
    const auto reported = [&](const std::string& start) {
        for (const auto& p : problems)
            if (p.compare(0, start.size(), start) == 0) return true;
        return false;
    };
    CHECK(reported("s.json: /end_time: must be > 0, is -5"));
    CHECK(reported("s.json: /gravty: unknown key (did you mean \"gravity\"?)"));
    CHECK(reported("s.json: /spheres/0/radius: must be > 0, is 0"));
    CHECK(reported("s.json: /spheres/1/position: must be a list of 3 numbers"));
    CHECK(reported("s.json: /planes/0/normal: must be a list of 3 numbers"));
    CHECK(reported("s.json: /spheres/3: sphere \"b\" overlaps sphere \"a\" (/spheres/2) by 1 "));
}

TEST_CASE("an overlap in a file names both bodies, the depth and the cure, and can be allowed", "[io]")
{
    const std::string text = scene_with(R"("spheres": [{"id": "a", "radius": 1, "position": [0, 0, 1]},
        {"id": "b", "radius": 1, "position": [1.75, 0, 1]}])");
    CHECK(problems_of(text) ==
          std::vector<std::string>{"s.json: /spheres/1: sphere \"b\" overlaps sphere \"a\" (/spheres/0) by 0.25 "
                                   "(move one by at least 0.2502, or pass --allow-overlap)"});
    ReadOptions options;
    options.allow_overlap = true;
    CHECK(parse_scene(text, "s.json", options).spheres.size() == 2);
}

TEST_CASE("an overlap inside a fill points at the fill", "[io]")
{
    CHECK_THAT(problem_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0]}],
        "fill": [{"pattern": "line", "count": 2, "radius": 1, "origin": [3.5, 0, 0], "axis": [-1, 0, 0]}])"),
               StartsWith("s.json: /fill/0: sphere \"fill-0/1\" overlaps sphere \"sphere-0\" (/spheres/0) by 0.5 "));
}

TEST_CASE("duplicate ids are errors that name both places", "[io]")
{
    CHECK(problem_with(R"("spheres": [{"id": "x", "radius": 1, "position": [0, 0, 5]}],
        "planes": [{"id": "x", "normal": [0, 0, 1], "offset": 0}])") ==
          "s.json: /planes/0: id \"x\" is already that of /spheres/0 (ids must be unique)");
}

TEST_CASE("a thousand equal slips do not make a thousand lines", "[io]")
{
    std::string spheres;
    for (int i = 0; i < 1000; ++i)
        spheres += std::string(i == 0 ? "" : ",") + "{\"radius\": -1, \"position\": [0, 0, 0]}";
    const auto problems = problems_of(scene_with("\"spheres\": [" + spheres + "]"));
    REQUIRE(problems.size() == 201);
    CHECK(problems.back() == "s.json: /: and 800 more problems");
}
