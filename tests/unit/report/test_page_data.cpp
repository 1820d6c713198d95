#include "report/page_data.hpp"
#include "report/scene_view.hpp"

#include <catch2/catch.hpp>

#include <limits>
#include <nlohmann/json.hpp>

using namespace carom;
using namespace carom::report;
using nlohmann::json;

namespace {

Scene ball_scene()
{
    Scene scene;
    scene.name = "Ball </script>";
    scene.gravity = Vec3(0, 0, -9.81);
    Sphere sphere;
    sphere.id = "ball";
    sphere.radius = 0.5;
    sphere.position = Vec3(0, 0, 1);
    scene.spheres.push_back(sphere);
    Plane floor, wall, back;
    floor.id = "floor";
    wall.id = "wall";
    wall.normal = Vec3(-1, 0, 0);
    wall.offset = -5;
    back.id = "back";
    back.normal = Vec3(0, 1, 0);
    back.offset = -2;
    scene.planes = {floor, wall, back};
    return scene;
}

Comparison some_comparison()
{
    Comparison comparison;
    comparison.until = comparison.reference.until = 2;
    comparison.sample_times = {0, 1, 2};
    comparison.tolerance = 0.25;
    comparison.reference.tracks = {{{0, 0, 1}}, {{2, 0, 1}}, {{4, 0, 1}}};
    CompareRow row;
    row.method = "pbd";
    row.dt = 1.0 / 240;
    row.substeps = 4;
    row.passes = 1;
    row.mistimed_impacts = 1;
    row.reference_impacts = 3;
    row.time = 1.5;
    row.position_max = std::numeric_limits<double>::quiet_NaN();
    row.series.penetration = {0, 0.1, 0.2};
    row.series.energy_error = {0, -0.5};
    row.series.position_max = {0, 1};
    row.series.tracks = {{{0, 0, 1}}, {{100, 0, std::numeric_limits<float>::quiet_NaN()}}};
    row.missed = {{0.5, 0, 1}};
    comparison.rows = {row};
    return comparison;
}

std::vector<unsigned> decode(const std::string& text)
{
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned> bytes, words;
    for (std::size_t i = 0; i + 3 < text.size(); i += 4) {
        unsigned group = 0, padding = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            padding += text[i + k] == '=';
            group = group << 6U | (text[i + k] == '=' ? 0U : static_cast<unsigned>(digits.find(text[i + k])));
        }
        for (unsigned k = 0; k < 3 - padding; ++k) bytes.push_back(group >> (16 - 8 * k) & 255U);
    }
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) words.push_back(bytes[i] | bytes[i + 1] << 8U);
    return words;
}

}  // namespace

TEST_CASE("page data have what the page asks for", "[page_data]")
{
    const std::string one = comparison_data(ball_scene(), some_comparison());
    const json page = json::parse(page_data(std::vector<std::string>{one, one}, "carom test"));
    CHECK(page["format"] == "carom-page/1");
    CHECK(page["generator"] == "carom test");
    REQUIRE(page["comparisons"].size() == 2);
    const json& comparison = page["comparisons"][1];
    for (const char* key :
         {"title", "description", "units", "verdict", "until", "reference", "rows", "series", "missed", "view"}) {
        CAPTURE(key);
        CHECK(comparison.contains(key));
    }
    CHECK(comparison["title"] == "Ball </script>");
    CHECK(comparison["tolerance"] == 0.25);
    CHECK(comparison["step_shown"].is_null());  // no row gave a finite answer
    CHECK(comparison["rows"][0]["mistimed_impacts"] == 1);
    CHECK(comparison["rows"][0]["reference_impacts"] == 3);
    CHECK(comparison["rows"][0]["time"] == 1.5);
    CHECK(comparison["rows"][0]["label"] == "pbd, dt = 1/240 in 4 substeps");
    CHECK(comparison["rows"][0]["position_max"].is_null());
    CHECK(comparison["missed"][0] == json({{"row", 0}, {"times", {0.5}}, {"names", {"ball - floor"}}}));
    const json& series = comparison["series"][0];
    CHECK(series["time"] == json({0.0, 1.0, 2.0}));
    CHECK(series["energy_error"][1] == -0.5);
    CHECK(series["energy_error"][2].is_null());  // the reference has ended
    CHECK(series["position_max"].size() == 3);
}

TEST_CASE("charts over time open at the verdict's step: the cheapest that is enough, else the best", "[page_data]")
{
    Comparison comparison = some_comparison();
    CompareRow coarse = comparison.rows[0], fine = comparison.rows[0];
    coarse.dt = 0.5;
    coarse.position_max = 0.75;
    coarse.missed_impacts = fine.missed_impacts = 1;
    fine.dt = 0.125;
    fine.position_max = 0.5;
    comparison.rows = {fine, coarse};
    const auto shown = [&] { return json::parse(comparison_data(ball_scene(), comparison))["step_shown"]; };
    CHECK(shown() == 0.125);
    comparison.tolerance = 1;
    CHECK(shown() == 0.5);  // the same CPU time: the larger step
}

TEST_CASE("the picture has gravity down, the motion across, and planes seen edge-on", "[page_data]")
{
    const json view = json::parse(comparison_data(ball_scene(), some_comparison()))["view"];
    CHECK(view["axes"] == json({"x", "z"}));
    CHECK(view["from_above"] == false);
    REQUIRE(view["planes"].size() == 2);  // the back wall is parallel to the view
    CHECK(view["planes"][0]["name"] == "floor");
    CHECK(view["planes"][1]["normal"] == json({-1.0, 0.0}));
    CHECK(view["planes"][0]["thickness"].is_null());
    CHECK(view["times"].size() == 3);
    // The window holds the ball, the floor and the wall.
    CHECK(view["min"][0] < -0.5);
    CHECK(view["max"][0] > 5);
    CHECK(view["min"][1] < 0);
    CHECK(view["max"][1] > 1.5);
    REQUIRE(view["tracks"].size() == 2);
    CHECK(view["tracks"][0]["row"] == -1);
    const std::vector<unsigned> track = decode(view["tracks"][0]["data"]);
    REQUIRE(track.size() == 6);
    const double low = view["min"][0], high = view["max"][0];
    for (std::size_t frame = 0; frame < 3; ++frame)
        CHECK(low + (high - low) * track[2 * frame] / 65535 == Approx(2.0 * static_cast<double>(frame)).margin(1e-3));
    const std::vector<unsigned> lost = decode(view["tracks"][1]["data"]);
    REQUIRE(lost.size() == 4);  // the run ended after two frames
    CHECK(lost[2] == 65535);    // outside: clamped
    CHECK(lost[3] == 0);        // not a number: at the edge
}

TEST_CASE("a table is seen from above, with gravity and without; what leaves it is seen from the side", "[page_data]")
{
    Comparison comparison = some_comparison();
    comparison.reference.tracks = {{{0, 0, 0.5F}}, {{2, 1, 0.5F}}, {{4, -1, 0.5F}}};
    for (const Vec3& gravity : {Vec3(0, 0, -9.81), Vec3(0, 0, 0)}) {
        Scene scene = ball_scene();
        scene.spheres[0].position.z() = 0.5;
        scene.gravity = gravity;
        CHECK(scene_view(scene, comparison).axes == std::array{0, 1});
        CHECK(scene_view(scene, comparison).from_above);
        // It rises by a third of what it moves along y.
        Comparison jump = comparison;
        jump.reference.tracks[1][0][2] = 1.2F;
        CHECK(scene_view(scene, jump).axes == std::array{0, 2});
    }
}

TEST_CASE("a crowd has fewer frames, not more bytes", "[page_data]")
{
    CHECK(frame_stride(1, 201, 20) == 1);
    CHECK(frame_stride(20, 201, 20) == 1);
    for (const std::size_t spheres : {100UL, 1000UL, 2000UL}) {
        const std::size_t stride = frame_stride(spheres, 201, 21);
        CHECK((200 / stride + 1) * spheres * 21 <= 1'100'000);
        CHECK(200 / stride >= 20);
    }
    CHECK(frame_stride(1'000'000, 201, 21) == 200);  // first and last
}

TEST_CASE("scenes of too many spheres have no picture", "[page_data]")
{
    Scene scene = ball_scene();
    scene.spheres.resize(max_track_spheres + 1, scene.spheres[0]);
    CHECK(json::parse(comparison_data(scene, some_comparison()))["view"].is_null());
}
