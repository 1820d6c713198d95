#include "io/assign.hpp"

#include <carom/io.hpp>
#include <catch2/catch.hpp>

#include "problems_of.hpp"

using namespace carom;
using namespace carom::test;
using Catch::Contains;

namespace {

const std::string ball = scene_with(
    R"("materials": {"a/b": {"restitution": 1}}, "spheres": [{"id": "ball", "radius": 1, "position": [0, 0, 5]}])");

Scene with(const std::vector<std::string>& set)
{
    ReadOptions options;
    options.set = set;
    return parse_scene(ball, "s.json", options);
}

/// All problems in one line.
std::string problems_with(const std::vector<std::string>& set)
{
    try {
        with(set);
    } catch (const InputError& error) {
        std::string all;
        for (const std::string& each : error.problems()) all += each + "\n";
        return all;
    }
    return "none";
}

}  // namespace

TEST_CASE("--set replaces values before the scene is read", "[io]")
{
    CHECK(with({"/spheres/0/radius=0.25"}).spheres[0].radius == 0.25);
    CHECK(with({"/spheres/0/position=[1, 2, 3]"}).spheres[0].position == Vec3(1, 2, 3));
    CHECK(with({"/spheres/0/position/2=7"}).spheres[0].position == Vec3(0, 0, 7));
    CHECK(with({"/end_time=1", "/end_time=2"}).end_time == 2);
    CHECK(with({"/materials/a~1b/restitution=0.5"}).materials[1].restitution == 0.5);
}

TEST_CASE("--set takes what is no JSON as a bare string", "[io]")
{
    CHECK(with({"/name=Two words"}).name == "Two words");
    CHECK(with({"/name=\"quoted\""}).name == "quoted");
    CHECK(with({"/name=a=b"}).name == "a=b");
    CHECK(with({"/name="}).name.empty());
    CHECK(std::get<std::string>(with({"/run/dt=1/240"}).run.at("dt")) == "1/240");
    CHECK(problems_with({"/name=5"}) == "s.json: /name: must be a string, is the number 5\n");
    CHECK(problems_with({"/end_time=.5"}) == "s.json: /end_time: must be a number, is the string \".5\"\n");
}

TEST_CASE("--set adds keys, sections and list elements", "[io]")
{
    CHECK(with({"/gravity=[0,0,-1]"}).gravity == Vec3(0, 0, -1));
    CHECK(with({"/rest/series_below=0"}).rest.series_below == 0);
    CHECK(with({"/spheres/-={\"radius\": 1, \"position\": [5, 0, 5]}"}).spheres.size() == 2);
    CHECK(with({"/spheres/-={\"radius\": 1, \"position\": [5, 0, 5]}", "/spheres/1/mass=3"}).spheres[1].mass == 3);
}

TEST_CASE("what --set gets wrong is said at its pointer", "[io]")
{
    CHECK_THAT(
        problems_with({"/spheres/7/radius=1"}),
        Contains("s.json: /spheres/7: --set: no such element, /spheres has 0 to 0 (write /spheres/- to add one)"));
    CHECK_THAT(problems_with({"/spheres/1/radius=1"}), Contains("s.json: /spheres/1: --set: no such element"));
    CHECK_THAT(problems_with({"/checks=[]", "/checks/0=1"}), Contains("/checks has none"));
    CHECK_THAT(problems_with({"/spheres/01x/radius=1"}), Contains("/spheres/01x: --set: no such element"));
    CHECK_THAT(problems_with({"/end_time/0=1"}), Contains("s.json: /end_time/0: --set: /end_time is the number 1"));
    CHECK_THAT(problems_with({"end_time=1"}), Contains("must begin with / (write /end_time=1)"));
    CHECK_THAT(problems_with({"end_time"}), Contains("is no assignment (write /pointer/to/key=value)"));
    CHECK_THAT(problems_with({"/end_time"}), Contains("is no assignment"));
    CHECK_THAT(problems_with({"=1"}), Contains("is no assignment"));
    CHECK_THAT(problems_with({"/a~2=1"}), Contains("is no assignment"));
    CHECK_THAT(problems_with({"/sphres/0/radius=1"}), Contains("/sphres: unknown key (did you mean \"spheres\"?)"));
    CHECK_THAT(problems_with({"/x/1=1", "/end_time/0=1", "/spheres/9=1"}),
               Contains("/end_time/0") && Contains("/spheres/9"));
}
