#include "cli/exit_codes.hpp"
#include "support/carom_tool.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace carom::cli;
using carom::test::carom_tool;
using carom::test::Said;
using Catch::Matchers::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Where tests keep traces that other engines made.
const fs::path traces = fs::path(CAROM_SCENE_DIR).parent_path() / "tests" / "traces";

/// A folder for one test, gone afterwards.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("carom-audit-" + std::to_string(::getpid()));
    Folder() { fs::remove_all(path); }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
};

json audited(const fs::path& trace, const std::string& scene, int code)
{
    const Said said = carom_tool({"audit", trace.string(), "--scene", scene, "--json"});
    CAPTURE(said.err);
    CHECK(said.code == code);
    return json::parse(said.out);
}

}  // namespace

TEST_CASE("frames of the event method have nothing missed and nothing invented, and say what is undecided", "[audit]")
{
    const Folder folder;
    for (const char* scene :
         {"bouncing_ball", "two_spheres", "bullet", "cradle", "cradle_2", "grazing", "corner", "incline",
          "counting_pi_2", "billiards_break", "far_away", "mass_ratio_light", "bernoulli"}) {
        CAPTURE(scene);
        REQUIRE(carom_tool({"run", scene, "--frames", "240", "-o", folder.path.string(), "-q"}).code == exit_ok);
        const json found = audited(folder.path / "frames.csv", scene, exit_ok);
        CHECK(found["missed"] == 0);
        CHECK(found["invented"] == 0);
        CHECK(found["late"] == 0);
        CHECK(found["early"] == 0);
        CHECK(found["overlaps"] == 0);
        CHECK(found["touches"]["found"].get<int>() + found["undecided"].get<int>() > 0);
        CHECK(found["body_intervals"]["decided"].get<double>() > 0.7 * found["body_intervals"]["all"].get<double>());
    }
}

TEST_CASE("places near 0 and bounces between frames give no findings", "[audit]")
{
    // A sphere whose steps are of 1e-9 beside its radius of 1, and a slot that is crossed a thousand times a frame.
    const Folder folder;
    for (const char* scene : {"grazing", "grazing_touch", "slot"}) {
        CAPTURE(scene);
        REQUIRE(carom_tool({"run", scene, "--frames", "997", "-o", folder.path.string(), "-q"}).code == exit_ok);
        CHECK(audited(folder.path / "frames.csv", scene, exit_ok)["findings"].empty());
    }
}

TEST_CASE("Bullet as it comes is shown to miss a thin plate at 1000 m/s", "[audit]")
{
    const Folder folder;
    const std::string scene = (traces / "thin_plate.json").string();
    const json found = audited(traces / "bullet_thin_plate.csv", scene, exit_check_failed);
    REQUIRE(found["missed"] == 1);
    CHECK(found["findings"][0]["a"] == "ball");
    CHECK(found["findings"][0]["b"] == "plate");
    CHECK(found["findings"][0]["time"].get<double>() == Approx(0.02989).epsilon(1e-12));

    const Said said = carom_tool(
        {"audit", (traces / "bullet_thin_plate.csv").string(), "--scene", scene, "-o", folder.path.string()});
    CHECK_THAT(said.out, Contains("missed   ball  plate  0.02989"));
    CHECK(carom_tool({"check", (folder.path / "missed-0.json").string()}).code == exit_ok);
    CHECK(fs::exists(folder.path / "audit.json"));
}

TEST_CASE("ODE's bounce is late by its step at most, and overlaps until then", "[audit]")
{
    const json found = audited(traces / "ode_drop.csv", (traces / "drop.json").string(), exit_check_failed);
    CHECK(found["missed"] == 0);
    CHECK(found["invented"] == 0);
    REQUIRE(found["late"] == 1);
    CHECK(found["overlaps"] == 1);
    const json& late = found["findings"][0];
    CHECK(late["kind"] == "late");
    // Its steps fall on a parabola that is half a step of gravity ahead: x = 1 m - g t (t + h) / 2.
    const double h = 1.0 / 60, touch = (std::sqrt(h * h + 8 / 9.81) - h) / 2;
    CHECK(late["time"].get<double>() == Approx(touch).epsilon(1e-9));
    CHECK(late["by"].get<double>() > 0);
    CHECK(late["by"].get<double>() < h);
}

TEST_CASE("a bad trace is exit 3 with its line, one in which nothing can be decided exit 4", "[audit]")
{
    const Folder folder;
    fs::create_directories(folder.path);
    const auto audit = [&](const std::string& text) {
        std::ofstream(folder.path / "trace.csv") << text;
        return carom_tool({"audit", (folder.path / "trace.csv").string(), "--scene", (traces / "drop.json").string()});
    };
    const Said bad = audit("t,id,x,y,z\n0,bell,0,0,1\n");
    CHECK(bad.code == exit_bad_input);
    CHECK_THAT(bad.err, Contains("trace.csv:2: no sphere \"bell\" in the scene (did you mean \"ball\"?)"));
    const Said nothing = audit("t,id,x,y,z\n10,ball,0,0,1\n11,ball,0,0,1\n");
    CHECK(nothing.code == exit_check_failed);
    CHECK_THAT(nothing.err, Contains("nothing could be decided"));
    CHECK(carom_tool({"audit", "no.csv", "--scene", "cradle"}).code == exit_bad_input);
    CHECK(carom_tool({"audit", "no.csv"}).code == exit_usage);
}

TEST_CASE("frames need a folder and a rate, and come from discrete methods as well", "[audit]")
{
    const Folder folder;
    CHECK(carom_tool({"run", "cradle", "--frames", "240"}).code == exit_usage);
    CHECK(carom_tool({"run", "cradle", "--frames", "0", "-o", folder.path.string()}).code == exit_usage);
    const std::vector<std::string> pbd{"run", "bouncing_ball",      "--method", "pbd", "--dt", "1/60", "--frames", "60",
                                       "-o",  folder.path.string(), "-q"};
    REQUIRE(carom_tool(pbd).code == exit_ok);
    const json found = audited(folder.path / "frames.csv", "bouncing_ball", exit_check_failed);
    CHECK(found["late"].get<int>() > 0);  // it answers at the ends of steps
    CHECK(found["invented"].get<int>() == 0);
}

TEST_CASE("frames of the event method under drag show no contact missed and none invented", "[cli]")
{
    const Folder folder;
    REQUIRE(carom_tool({"run", "viscous_throw", "--frames", "240", "-o", (folder.path / "run").string(), "-q"}).code ==
            exit_ok);
    const Said said =
        carom_tool({"audit", (folder.path / "run/frames.csv").string(), "--scene", "viscous_throw", "--json"});
    CHECK(said.code == exit_ok);
    const json result = json::parse(said.out);
    CHECK(result["touches"]["found"] > 0);
    for (const char* kind : {"missed", "late", "early", "invented", "overlaps"}) CHECK(result[kind] == 0);
}

TEST_CASE("frames denser than the steps of a method decide nothing, and --step keeps those at its steps", "[cli]")
{
    const Folder folder;
    REQUIRE(carom_tool({"run", "bouncing_ball", "--method", "velocity", "--dt", "1/60", "--frames", "240", "--until",
                        "0.3", "-o", (folder.path / "run").string(), "-q"})
                .code == exit_ok);
    const std::vector<std::string> audit{"audit", (folder.path / "run/frames.csv").string(), "--scene",
                                         "bouncing_ball"};
    const Said dense = carom_tool(audit);
    CHECK(dense.code == exit_check_failed);
    CHECK_THAT(dense.err, Contains("nothing could be decided") && Contains("--step H"));
    std::vector<std::string> more = audit;
    more.insert(more.end(), {"--step", "1/60"});
    const Said judged = carom_tool(more);
    CHECK(judged.code == exit_ok);
    more.back() = "0.0123";
    CHECK_THAT(carom_tool(more).err, Contains("fewer than two frames fall on steps"));
}
