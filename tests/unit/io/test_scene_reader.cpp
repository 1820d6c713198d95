#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "problems_of.hpp"

using namespace carom;
using namespace carom::test;
using Catch::Contains;

TEST_CASE("the example of the contract is read with the right values", "[io]")
{
    const Scene s =
        parse_scene(R"({"$schema": "../scene.schema.json", "format": "carom-scene/1", "name": "Bouncing ball",
 "description": "Every bounce is known in closed form; they end at 9 sqrt(2h/g).",
 "gravity": [0, 0, -9.81], "end_time": 5, "seed": 1,
 "materials": {"rubber": {"restitution": 0.8, "tangential": 1, "color": "#d1495b"}}, "rest": {"policy": "contact"},
 "spheres": [{"id": "ball", "radius": 0.1, "mass": 1, "position": [0, 0, 1.1], "velocity": [0.2, 0, 0], "material": "rubber"}],
 "planes": [{"id": "floor", "normal": [0, 0, 1], "offset": 0, "material": "rubber"}],
 "checks": [{"type": "no_overlap"}, {"type": "event_time", "event": 0, "time": 0.451523640985731, "abs": 1e-13}],
 "compare": {"methods": ["event", "pbd", "velocity"], "dt": ["1/60", "1/240", 0.001, 0.0001]}})",
                    "ball.json");
    CHECK(s.name == "Bouncing ball");
    CHECK(s.gravity == Vec3(0, 0, -9.81));
    CHECK(s.end_time == 5);
    CHECK(s.seed == 1);
    REQUIRE(s.materials.size() == 2);
    CHECK(s.materials[0].name == "default");
    CHECK(s.materials[1].restitution == 0.8);
    CHECK(s.materials[1].color == "#d1495b");
    REQUIRE(s.spheres.size() == 1);
    CHECK(s.spheres[0].id == "ball");
    CHECK(s.spheres[0].radius == 0.1);
    CHECK(s.spheres[0].position == Vec3(0, 0, 1.1));
    CHECK(s.spheres[0].velocity == Vec3(0.2, 0, 0));
    CHECK(s.spheres[0].material == 1);
    REQUIRE(s.planes.size() == 1);
    CHECK(s.planes[0].normal == Vec3(0, 0, 1));
    CHECK_FALSE(s.planes[0].thickness.has_value());
    REQUIRE(s.checks.size() == 2);
    CHECK(s.checks[0].type == CheckType::no_overlap);
    CHECK(s.checks[1].time == 0.451523640985731);
    CHECK(s.checks[1].abs == 1e-13);
    CHECK_FALSE(s.checks[1].rel.has_value());
    CHECK(std::get<std::vector<std::string>>(s.compare.at("methods")) ==
          std::vector<std::string>{"event", "pbd", "velocity"});
    CHECK(std::get<std::vector<std::string>>(s.compare.at("dt")) ==
          std::vector<std::string>{"1/60", "1/240", "0.001", "0.0001"});
}

TEST_CASE("what a scene leaves out has its default", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0]}, {"radius": 1,
        "position": [3, 0, 0], "fixed": false}], "planes": [{"normal": [0, 0, 2], "offset": -1}],
        "origin": [0, 0, 0], "start_time": 0)"),
                                "folder/two.json");
    CHECK(s.name == "two");
    CHECK(s.gravity == Vec3::Zero());
    CHECK(s.seed == 1);
    CHECK(s.spheres[1].id == "sphere-1");
    CHECK(s.spheres[1].mass == 1);
    CHECK(s.spheres[1].velocity == Vec3::Zero());
    CHECK(s.spheres[1].material == 0);
    CHECK(s.planes[0].id == "plane-0");
    CHECK(s.rest.series_below == 1e-3);
    CHECK_FALSE(s.rest.window.has_value());
}

TEST_CASE("a density gives the mass of the ball", "[io]")
{
    const Scene s =
        parse_scene(scene_with(R"("spheres": [{"radius": 0.1, "density": 7800, "position": [0, 0, 0]}])"), "s.json");
    CHECK(s.spheres[0].mass == Approx(7800 * 4.0 / 3 * 3.14159265358979323846 * 1e-3).epsilon(1e-15));
}

TEST_CASE("a plane's normal is normalised and its offset refers to the normalised one", "[io]")
{
    const Scene s = parse_scene(
        scene_with(R"("planes": [{"normal": [3, 0, 4], "offset": 2}, {"normal": [0, 5, 0], "point": [7, 3, 9]},
        {"normal": [3e-200, 0, 4e-200], "offset": 1}, {"normal": [3e200, 0, 4e200], "offset": 1, "thickness": 0}])"),
        "s.json");
    CHECK((s.planes[0].normal - Vec3(0.6, 0, 0.8)).cwiseAbs().maxCoeff() < 1e-16);
    CHECK(s.planes[0].offset == 2);
    CHECK(s.planes[1].offset == 3);
    CHECK((s.planes[2].normal - Vec3(0.6, 0, 0.8)).cwiseAbs().maxCoeff() < 2e-16);
    CHECK((s.planes[3].normal - Vec3(0.6, 0, 0.8)).cwiseAbs().maxCoeff() < 2e-16);
    CHECK(s.planes[3].thickness == 0.0);
}

TEST_CASE("a box makes walls with inward normals in a fixed order, but for its open sides", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("materials": {"wall": {"restitution": 0.5}},
        "box": {"min": [-1, -2, -3], "max": [1, 2, 3], "walls": ["solid", "solid", "solid"], "open": ["+z", "-y"],
                "material": "wall"}, "spheres": [{"radius": 0.5, "position": [0, 0, 0]}])"),
                                "s.json");
    REQUIRE(s.planes.size() == 4);
    const std::vector<std::string> ids{"box-x", "box+x", "box+y", "box-z"};
    const std::vector<double> gaps{0.5, 0.5, 1.5, 2.5};
    for (std::size_t p = 0; p < ids.size(); ++p) {
        CHECK(s.planes[p].id == ids[p]);
        CHECK(s.planes[p].material == 1);
        CHECK(plane_gap(s.planes[p], s.spheres[0], s.spheres[0].position) == gaps[p]);
    }
    CHECK(s.planes[1].normal == Vec3(-1, 0, 0));
    CHECK(s.planes[3].normal == Vec3(0, 0, 1));
}

TEST_CASE("contacts override the materials' values", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("materials": {"a": {"restitution": 0.5}, "b": {}},
        "contacts": [{"between": ["b", "a"], "restitution": 0.9, "tangential": 0.7, "attenuation": 0.99}])"),
                                "s.json");
    const ContactLaw law = sphere_contact_law(s, 1, 2);
    CHECK(law.restitution == 0.9);
    CHECK(law.tangential == 0.7);
    CHECK(law.attenuation == 0.99);
    CHECK(sphere_contact_law(s, 1, 1).restitution == 0.5);
}

TEST_CASE("every kind of check is read", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("spheres": [{"radius": 1, "position": [0, 0, 0]}],
        "fill": [{"pattern": "line", "count": 2, "radius": 1, "origin": [5, 0, 0]}],
        "checks": [{"type": "no_overlap"}, {"type": "energy", "rel": 1e-12}, {"type": "momentum", "abs": 1e-12},
        {"type": "inside"}, {"type": "event_time", "event": 3, "time": 0.5, "rel": 0}, {"type": "event_count", "count": 7},
        {"type": "event_count", "count": 1, "kind": "rest"}, {"type": "rest_time", "body": "fill-0/1", "time": 0.25},
        {"type": "final_position", "body": "sphere-0", "value": [1, 2, 3]},
        {"type": "final_velocity", "body": "fill-0/0", "value": [4, 5, 6], "abs": 1}])"),
                                "s.json");
    REQUIRE(s.checks.size() == 10);
    CHECK(s.checks[1].rel == 1e-12);
    CHECK(s.checks[4].index == 3);
    CHECK(s.checks[5].count == 7);
    CHECK(s.checks[5].kind == EventKind::impact);
    CHECK(s.checks[6].kind == EventKind::rest);
    CHECK(s.checks[7].body == 2);
    CHECK(s.checks[8].body == 0);
    CHECK(s.checks[8].value == Vec3(1, 2, 3));
    CHECK(s.checks[9].body == 1);
}

TEST_CASE("checks of two bodies, of places and of second runs are read", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("spheres": [{"id": "ball", "radius": 1, "position": [0, 0, 2]}],
        "planes": [{"id": "floor", "normal": [0, 0, 1], "offset": 0}],
        "checks": [{"type": "event_time", "event": 1, "between": ["floor", "ball"], "time": 0.5},
        {"type": "position", "body": "ball", "time": 0.25, "value": [1, 2, 3]}, {"type": "moved", "value": [4, 5, 6]},
        {"type": "later", "time": 7}, {"type": "reversed", "abs": 1}])"),
                                "s.json");
    REQUIRE(s.checks.size() == 5);
    REQUIRE(s.checks[0].between);
    CHECK(*s.checks[0].between == std::array<BodyId, 2>{1, 0});
    CHECK(s.checks[1].time == 0.25);
    CHECK(s.checks[1].value == Vec3(1, 2, 3));
    CHECK(s.checks[2].value == Vec3(4, 5, 6));
    CHECK(s.checks[3].time == 7);
    CHECK(s.checks[4].type == CheckType::reversed);
}

TEST_CASE("a scene's part in a stress case is read", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("stress": {"case": "any", "dt": 0.1, "exact": 1e-12, "title": "Any",
        "figure": "what", "step": "how", "causes": {"late": "why"}})"),
                                "s.json");
    REQUIRE(s.stress);
    CHECK(s.stress->case_name == "any");
    CHECK(s.stress->dt == 0.1);
    CHECK(s.stress->exact == 1e-12);
    CHECK(s.stress->limit == 0.01);
    CHECK(s.stress->title == "Any");
    CHECK(s.stress->figure == "what");
    CHECK(s.stress->step == "how");
    CHECK(s.stress->causes == std::map<Symptom, std::string>{{Symptom::late, "why"}});
    CHECK(s.stress->waits_for.empty());
    CHECK(s.stress->members.empty());
    CHECK_FALSE(s.stress->stiffness);
    CHECK_FALSE(parse_scene(scene_with(""), "s.json").stress);
}

TEST_CASE("variations of a stress scene are assignments, with the digits of the file", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("stress": {"case": "any", "dt": 0.1, "exact": 1, "stiffness": 100,
        "waits_for": "better days", "members": [{"name": "e = 0.90", "set": {"/materials/m/restitution": 0.90,
        "/spheres": [{"id": "a \"b\"", "fixed": true}, null]}}]})"),
                                "s.json");
    CHECK(s.stress->stiffness == 100);
    CHECK(s.stress->waits_for == "better days");
    REQUIRE(s.stress->members.size() == 1);
    CHECK(s.stress->members[0].name == "e = 0.90");
    CHECK(s.stress->members[0].set == std::vector<std::string>{"/materials/m/restitution=0.90",
                                                               R"(/spheres=[{"id":"a \"b\"","fixed":true},null])"});
    CHECK_THROWS_WITH(parse_scene(scene_with(R"("stress": {"case": "any", "dt": 0.1, "exact": 1,
        "members": [{"name": "x", "set": {"end_time": 2}}]})"),
                                  "s.json"),
                      Contains("/stress/members/0/set") && Contains("must begin with /"));
    CHECK_THROWS_WITH(parse_scene(scene_with(R"("stress": {"case": "any", "dt": 0.1, "exact": 1,
        "members": [{"set": {}}]})"),
                                  "s.json"),
                      Contains("/stress/members/0") && Contains("name") && Contains("must be an object"));
}

TEST_CASE("rest options and command defaults are kept", "[io]")
{
    const Scene s = parse_scene(scene_with(R"("rest": {"closing_speed": 0.1, "window": 0.2, "numeric_step": 0.3,
        "gap_tolerance": 0.4, "series_below": 0}, "run": {"method": "pbd", "dt": 0.001, "literal": true},
        "tunnel": {"speed": "1:1e6:log7"}, "view": {}, "seed": 18446744073709551615)"),
                                "s.json");
    CHECK(s.rest.closing_speed == 0.1);
    CHECK(s.rest.window == 0.2);
    CHECK(s.rest.numeric_step == 0.3);
    CHECK(s.rest.gap_tolerance == 0.4);
    CHECK(s.rest.series_below == 0);
    CHECK(std::get<std::string>(s.run.at("method")) == "pbd");
    CHECK(std::get<double>(s.run.at("dt")) == 0.001);
    CHECK(std::get<bool>(s.run.at("literal")));
    CHECK(std::get<std::string>(s.tunnel.at("speed")) == "1:1e6:log7");
    CHECK(s.view.empty());
    CHECK(s.seed == 18446744073709551615ULL);
}

TEST_CASE("spheres come first and fills follow in file order", "[io]")
{
    const Scene s =
        parse_scene(scene_with(R"("fill": [{"pattern": "line", "count": 2, "radius": 1, "origin": [5, 0, 0]},
        {"id": "far", "pattern": "line", "count": 1, "radius": 1, "origin": [50, 0, 0]}],
        "spheres": [{"radius": 1, "position": [0, 0, 0]}])"),
                    "s.json");
    REQUIRE(s.spheres.size() == 4);
    CHECK(s.spheres[0].id == "sphere-0");
    CHECK(s.spheres[1].id == "fill-0/0");
    CHECK(s.spheres[2].id == "fill-0/1");
    CHECK(s.spheres[3].id == "far/0");
}

TEST_CASE("a seed given by the caller replaces that of the scene", "[io]")
{
    const std::string text = scene_with(R"("seed": 5, "box": {"min": [0, 0, 0], "max": [1, 1, 1]},
        "fill": [{"pattern": "random", "count": 3, "radius": 0.1}])");
    ReadOptions options;
    options.seed = 6;
    const Scene own = parse_scene(text, "s.json"), other = parse_scene(text, "s.json", options);
    CHECK(own.seed == 5);
    CHECK(other.seed == 6);
    CHECK(own.spheres[0].position != other.spheres[0].position);
}

TEST_CASE("reading is stopped where it takes long: in the text, in a fill, in the search for overlaps")
{
    const std::string many = [] {
        std::string text = R"({"format": "carom-scene/1", "end_time": 1, "spheres": [)";
        for (int i = 0; i < 5000; ++i)
            text += (i > 0 ? "," : "") + (R"({"radius": 0.1, "position": [)" + std::to_string(i) + ", 0, 0]}");
        return text + "]}";
    }();
    const std::string fill = R"({"format": "carom-scene/1", "end_time": 1, "fill": [{"id": "atom", "pattern": "random",
        "count": 5000, "radius": 0.1, "min": [0, 0, 0], "max": [10, 10, 10]}]})";
    std::set<std::string> stages;
    ReadOptions watched;
    watched.on_progress = [&](const Progress& now) {
        CHECK(now.fraction >= 0);
        CHECK(now.fraction <= 1);
        stages.insert(now.stage);
        return true;
    };
    CHECK(parse_scene(many, "many.json", watched).spheres.size() == 5000);
    CHECK(parse_scene(fill, "fill.json", watched).spheres.size() == 5000);
    CHECK(stages == std::set<std::string>{"scene file", "spheres", "atom", "overlaps"});
    for (const std::string& stage : stages) {
        CAPTURE(stage);
        ReadOptions stopped;
        stopped.on_progress = [&](const Progress& now) { return now.stage != stage; };
        CHECK_THROWS_AS(parse_scene(stage == "atom" ? fill : many, "f.json", stopped), Stopped);
    }
}
