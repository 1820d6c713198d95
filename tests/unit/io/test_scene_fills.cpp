#include <catch2/catch.hpp>

#include "problems_of.hpp"

using namespace carom;
using namespace carom::test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

std::string unit_box(const std::string& fill)
{
    return R"("box": {"min": [0, 0, 0], "max": [1, 1, 1]}, "fill": [)" + fill + "]";
}

}  // namespace

TEST_CASE("a fill without a region goes into the box, one with a region into that", "[io]")
{
    const Scene s = parse_scene(scene_with(unit_box(R"({"pattern": "random", "count": 20, "radius": 0.05},
        {"id": "up", "pattern": "cubic", "count": 8, "radius": 0.05, "min": [2, 0, 0.5], "max": [3, 1, 1.5]})")),
                                "s.json", {true, {}});
    REQUIRE(s.spheres.size() == 28);
    for (std::size_t i = 0; i < 20; ++i) {
        CHECK(s.spheres[i].position.minCoeff() >= 0.05);
        CHECK(s.spheres[i].position.maxCoeff() <= 0.95);
    }
    CHECK(s.spheres[20].id == "up/0");
    CHECK(s.spheres[20].position == Vec3(2.25, 0.25, 0.75));
}

TEST_CASE("radii of a fill are a number, uniform or a choice", "[io]")
{
    const Scene s =
        parse_scene(scene_with(unit_box(R"({"pattern": "random", "count": 50, "radius": {"uniform": [0.01, 0.03]}},
        {"pattern": "random", "count": 50, "radius": {"choice": [0.01, 0.02]}, "density": 3})")),
                    "s.json");
    bool small = false, large = false;
    for (std::size_t i = 0; i < 50; ++i) {
        CHECK(s.spheres[i].radius >= 0.01);
        CHECK(s.spheres[i].radius < 0.03);
        const double r = s.spheres[50 + i].radius;
        small = small || r == 0.01;
        large = large || r == 0.02;
        CHECK((r == 0.01 || r == 0.02));
        CHECK(s.spheres[50 + i].mass == Approx(3 * 4.18879020478639 * r * r * r));
    }
    CHECK(small);
    CHECK(large);
}

TEST_CASE("a fill that is too dense is refused with how many fit", "[io]")
{
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "random", "count": 600, "radius": 0.05})")),
               StartsWith("s.json: /fill/0/count: packing fraction 0.3142 is above 0.3") &&
                   Contains("not yet supported (take at most 572 spheres"));
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "cubic", "count": 1001, "radius": 0.05})")),
               StartsWith("s.json: /fill/0/count: 1001 spheres of diameter 0.1 do not fit"));
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "random", "count": 1, "radius": 0.6})")),
               StartsWith("s.json: /fill/0/radius: a sphere of radius 0.6 does not fit into the region"));
}

TEST_CASE("a fill that finds no room ends and says so", "[io]")
{
    CHECK_THAT(problem_with(R"("spheres": [{"radius": 0.5, "position": [0.5, 0.5, 0.5]}],)" +
                            unit_box(R"({"pattern": "random", "count": 20, "radius": 0.12})")),
               StartsWith("s.json: /fill/0/count: found no room for more than "));
}

TEST_CASE("slips in a fill are reported at their pointers", "[io]")
{
    CHECK_THAT(problem_with(R"("fill": [{"pattern": "random", "count": 1, "radius": 1}])"),
               StartsWith("s.json: /fill/0: has no region"));
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "random", "count": 0, "radius": 0.1})")),
               StartsWith("s.json: /fill/0/count: must be an integer from 1 to"));
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "randon", "count": 1, "radius": 0.1, "zzz": 1})")),
               StartsWith("s.json: /fill/0/pattern: \"randon\": unknown (did you mean \"random\"?)"));
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "random", "count": 1, "radius": 0.1, "gap": 1})")),
               StartsWith("s.json: /fill/0/gap: unknown key"));
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "random", "count": 1, "radius": {"uniform": [2, 1]}})")),
               StartsWith("s.json: /fill/0/radius/uniform: must be [a, b] with 0 < a <= b"));
    CHECK_THAT(problem_with(unit_box(R"({"pattern": "random", "count": 1, "radius": {"choice": []}})")),
               StartsWith("s.json: /fill/0/radius/choice: must have at least one"));
    CHECK_THAT(problem_with(R"("fill": [{"pattern": "triangle", "rows": 2, "radius": 1, "axis": [0, 0, 2]}])"),
               StartsWith("s.json: /fill/0/axis: must not be along z"));
    CHECK_THAT(problem_with(R"("fill": [{"pattern": "triangle", "rows": 2, "radius": {"uniform": [1, 2]}}])"),
               StartsWith("s.json: /fill/0/radius: must be one number"));
    CHECK_THAT(problem_with(R"("box": {"min": [0, 0, 0], "max": [1, 1, -1]},
        "fill": [{"pattern": "random", "count": 1, "radius": 0.1}])"),
               StartsWith("s.json: /box/max: "));
}
