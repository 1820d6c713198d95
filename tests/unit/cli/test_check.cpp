#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "support/carom_tool.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <carom/io.hpp>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

using namespace carom::cli;
using carom::test::carom_tool;
using carom::test::Said;
using Catch::Matchers::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

constexpr const char* ball_scene =
    R"({"format": "carom-scene/1", "name": "Ball", "end_time": 2,
 "spheres": [{"id": "ball", "radius": 1, "position": [0, 0, 2], "velocity": [0, 0, -1]}],
 "planes": [{"id": "floor", "normal": [0, 0, 1], "offset": 0}],
 "checks": [{"type": "no_overlap"}, {"type": "event_time", "event": 0, "time": 1, "abs": 1e-15}]})";

class File {
public:
    explicit File(const std::string& text)
        : path_(fs::temp_directory_path() / ("carom-check-" + std::to_string(::getpid()) + ".json"))
    {
        std::ofstream(path_) << text;
    }
    ~File() { fs::remove(path_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    std::string path() const { return path_.string(); }

private:
    fs::path path_;
};

}  // namespace

TEST_CASE("check says which checks hold, and exits with 4 if one fails", "[cli]")
{
    const File file(ball_scene);
    const Said good = carom_tool({"check", file.path()});
    CHECK(good.code == exit_ok);
    CHECK_THAT(good.out, Contains("(Ball): 2 of 2 checks hold") && Contains("event_time 0"));
    const Said bad = carom_tool({"check", file.path(), "--set", "/spheres/0/velocity/2=-2"});
    CHECK(bad.code == exit_check_failed);
    CHECK_THAT(bad.out, Contains("1 of 2 checks hold") && Contains("fails: event_time 0: expected 1, found 0.5"));
    const Said as_json = carom_tool({"check", file.path(), "--json", "--set", "/spheres/0/velocity/2=-2"});
    CHECK(as_json.code == exit_check_failed);
    const json report = json::parse(as_json.out);
    CHECK(report["format"] == "carom-check/1");
    CHECK(report["passed"] == false);
    CHECK(report["scenes"][0]["checks"][0]["verdict"] == "holds");
    CHECK(report["scenes"][0]["checks"][1]["verdict"] == "fails");
    CHECK(report["scenes"][0]["checks"][1]["error"] == 0.5);
}

TEST_CASE("check exits with 1 where a run ends unresolved and nothing fails, with 4 where something does", "[cli]")
{
    // A light ball of a heap squeezed between the floor and a heavy one: impacts accumulate, and the guard is off.
    const std::vector<std::string> jam{
        "--set",
        R"(/materials={"lossy": {"restitution": 0.999}})",
        "--set",
        "/guard=off",
        "--set",
        R"(/fill=[{"pattern": "line", "count": 12, "radius": 0.1, "gap": 5e-5, "origin": [0.20005, 0, 0.1005], "material": "lossy"}])",
        "--set",
        R"(/rest={"closing_speed": 0, "window": 0, "numeric_step": 0.01})",
        "--set",
        R"(/spheres=[{"radius": 0.1, "mass": 1e-6, "position": [0, 0, 0.1005], "material": "lossy"},
        {"radius": 0.1, "mass": 1e6, "position": [0, 0, 1.301], "velocity": [0, 0, -1], "material": "lossy"}])"};
    const File file(ball_scene);
    std::vector<std::string> args{"check", file.path(), "--set", "/checks=[{\"type\": \"no_overlap\"}]"};
    args.insert(args.end(), jam.begin(), jam.end());
    const Said open = carom_tool(args);
    CHECK(open.code == exit_failed);
    CHECK_THAT(open.out, Contains("open: no_overlap: the run ended unresolved at t = 1"));
    CHECK_THAT(open.err, Contains("accumulate"));
    args[3] = R"(/checks=[{"type": "no_overlap"}, {"type": "event_count", "kind": "rest", "count": 0, "abs": 0}])";
    CHECK(carom_tool(args).code == exit_failed);  // nothing has come to rest before the jam
    args[3] = R"(/checks=[{"type": "no_overlap"}, {"type": "event_count", "count": 0, "abs": 0}])";
    CHECK(carom_tool(args).code == exit_check_failed);  // but there were impacts
}

TEST_CASE("a scene without checks is told so with the cure, and nothing is run", "[cli]")
{
    const File file(ball_scene);
    for (const char* json_or_not : {"--no-progress", "--json"}) {
        const Said none = carom_tool({"check", file.path(), "bouncing_ball", "--set", "/checks=[]", json_or_not});
        CHECK(none.code == exit_bad_input);
        CHECK(none.out.empty());
        CHECK_THAT(none.err, Contains(file.path() + ": /checks: the scene has none") &&
                                 Contains("bouncing_ball.json: /checks: the scene has none") &&
                                 Contains("\"checks\": [{\"type\": \"no_overlap\"}]"));
    }
}

TEST_CASE("--set changes scenes of run and compare, and its errors name the pointer", "[cli]")
{
    const File file(ball_scene);
    const json run = json::parse(carom_tool({"run", file.path(), "--json", "--set", "/spheres/0/id=other"}).out);
    CHECK(run["final"][0]["id"] == "other");
    const Said wrong = carom_tool({"run", file.path(), "--set", "/spheres/5/id=other"});
    CHECK(wrong.code == exit_bad_input);
    CHECK_THAT(wrong.err, Contains("/spheres/5: --set: no such element"));
    CHECK(carom_tool({"compare", file.path(), "--set", "/end_time=0"}).code == exit_bad_input);
}

TEST_CASE("scenes are validated, one or all, and the schema is printed", "[cli]")
{
    const File file(R"({"format": "carom-scene/1", "end_time": -1, "spheres": 3})");
    const Said bad = carom_tool({"scenes", "validate", file.path(), "bouncing_ball"});
    CHECK(bad.code == exit_bad_input);
    CHECK_THAT(bad.out, Contains("bouncing_ball.json: valid"));
    CHECK_THAT(bad.err, Contains("/end_time: must be > 0") && Contains("/spheres: must be a list"));
    const json report = json::parse(carom_tool({"scenes", "validate", file.path(), "--json"}).out);
    CHECK(report["scenes"][0]["valid"] == false);
    CHECK(report["scenes"][0]["problems"].size() == 2);
    CHECK(carom_tool({"scenes", "validate"}).code == exit_ok);
    const File steps(R"({"format": "carom-scene/1", "end_time": 1, "compare": {"dt": ["1/60", 0]}})");
    const Said wrong_step = carom_tool({"scenes", "validate", steps.path()});
    CHECK(wrong_step.code == exit_bad_input);
    CHECK_THAT(wrong_step.err, Contains("/compare/dt: 0 in \"1/60,0\" must be > 0"));
    CHECK(json::parse(carom_tool({"scenes", "schema"}).out)["title"] == "carom-scene/1");
}

TEST_CASE("a scene's defaults may ask for all final states", "[cli]")
{
    const File file(R"({"format": "carom-scene/1", "end_time": 1, "run": {"final": true},
        "fill": [{"pattern": "line", "count": 1001, "radius": 1, "gap": 1}]})");
    CHECK(json::parse(carom_tool({"run", file.path(), "--json"}).out)["final"].size() == 1001);
    CHECK_FALSE(
        json::parse(carom_tool({"run", file.path(), "--json", "--set", "/run/final=false"}).out).contains("final"));
}

TEST_CASE("every scene of the catalogue passes its checks, but for those that wait for what is not built", "[cli]")
{
    const std::set<std::string> long_ones{"settle_1000"};  // 40 CPU s
    for (const carom::CatalogueEntry& entry : carom::list_scenes(scene_folder())) {
        CAPTURE(entry.name);
        CHECK(fs::exists(fs::path(entry.path).replace_extension(".svg")));
        const std::optional<carom::StressPart> stress = carom::read_scene(entry.path).stress;
        if (!long_ones.contains(entry.name) && (!stress || stress->waits_for.empty()))
            CHECK(carom_tool({"check", entry.path.string(), "--json"}).code == exit_ok);
    }
}
