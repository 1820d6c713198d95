#include "cli/exit_codes.hpp"
#include "support/carom_tool.hpp"

#include <carom/io.hpp>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace carom::cli;
using carom::test::carom_tool;
using carom::test::Said;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A folder for one test, gone afterwards.
class Folder {
public:
    Folder() : path_(fs::temp_directory_path() / ("carom-tunnel-" + std::to_string(::getpid())))
    {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    std::string read(const std::string& name) const
    {
        std::ifstream stream(path_ / name);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

private:
    fs::path path_;
};

/// `carom tunnel` at one plate with its critical speed at 6.6, and at a sphere of the same size.
std::vector<std::string> small(std::vector<std::string> more)
{
    std::vector<std::string> args{"tunnel", "--radius", "0.1",  "--thickness", "0.02",        "--dt",
                                  "1/60",   "--speed",  "6,60", "--target",    "plate,sphere"};
    args.insert(args.end(), more.begin(), more.end());
    return args;
}

}  // namespace

TEST_CASE("tunnel throws, prints the law beside the shares and exits 0 where event hits every time", "[cli]")
{
    const Said said = carom_tool(small({"--methods", "event,velocity", "--trials", "400"}));
    CHECK(said.code == exit_ok);
    CHECK_THAT(said.out, Contains("tunnelled") && Contains("law"));
    CHECK_THAT(said.out, Contains("event hits in every one of 1600 throws"));
    CHECK_THAT(said.out, Contains("velocity: ") && Contains("plates from 9.09"));
}

TEST_CASE("tunnel --json has rows and critical speeds within 2 % of the law", "[cli]")
{
    const Said said = carom_tool(
        small({"--methods", "event,pbd", "--trials", "50", "--bisect", "--offset", "0,0.9", "--json", "--seed", "7"}));
    REQUIRE(said.code == exit_ok);
    const json result = json::parse(said.out);
    CHECK(result["format"] == "carom-tunnel/1");
    CHECK(result["event_holds"] == true);
    CHECK(result["seed"] == 7);
    CHECK(result["stopped"].is_null());
    REQUIRE(result["rows"].size() == 8);
    CHECK(result["rows"][0]["method"] == "event");
    CHECK(result["rows"][5]["number"] == Approx(60.0 / 60 / 0.11));
    REQUIRE(result["critical"].size() == 6);
    for (const json& row : result["critical"]) {
        if (row["method"] == "event") {
            CHECK(row["critical_speed"].is_null());
            continue;
        }
        const double law = row["offset"] == 0 ? 6.6 : 6.6 * std::sqrt(1 - 0.81);
        CHECK(row["critical_speed"] == Approx(law).epsilon(0.02));
    }
}

TEST_CASE("tunnel -o writes CSV, JSON, a page, and scenes that show what tunnels", "[cli]")
{
    const Folder folder;
    const Said said =
        carom_tool(small({"--methods", "event,velocity", "--bisect", "--trials", "50", "-o", folder / "out"}));
    REQUIRE(said.code == exit_ok);
    CHECK_THAT(folder.read("out/tunnel.csv"),
               StartsWith("method,dt,speed,radius,thickness,trials,tunnelled,wrong,worst_error,target,integrator,"));
    CHECK_THAT(folder.read("out/critical.csv"),
               StartsWith("method,dt,radius,thickness,target,offset,critical_speed,law"));
    CHECK(json::parse(folder.read("out/tunnel.json"))["rows"].size() == 8);
    CHECK_THAT(folder.read("out/report.html"), Contains("carom-tunnel-page/1"));
    CHECK_FALSE(fs::exists(folder / "out/throws/event.json"));

    // The scene runs as it was thrown: velocity sees nothing, event the contact.
    const std::string scene = folder / "out/throws/velocity.json";
    REQUIRE(fs::exists(scene));
    const auto impacts = [&](std::vector<std::string> more) {
        std::vector<std::string> args{"run", scene, "--json"};
        args.insert(args.end(), more.begin(), more.end());
        return json::parse(carom_tool(args).out)["counts"]["impacts"].get<int>();
    };
    CHECK(impacts({}) == 0);
    CHECK(impacts({"--method", "event"}) == 1);
    CHECK(carom_tool({"compare", scene, "--methods", "event,velocity", "-q", "-o", folder / "compare"}).code ==
          exit_ok);
}

TEST_CASE("tunnel SCENE throws the scene's fastest body; its section tunnel gives defaults", "[cli]")
{
    const Folder folder;
    std::ofstream(folder / "bullet.json") << R"({"format": "carom-scene/1", "name": "Shot", "end_time": 1,
 "spheres": [{"id": "bullet", "radius": 0.1, "position": [-5, 0, 0], "velocity": [10, 0, 0]}],
 "planes": [{"id": "plate", "normal": [1, 0, 0], "offset": 0, "thickness": 0.02}],
 "tunnel": {"speed": [5, 500], "dt": "1/60", "methods": ["velocity", "toi"], "trials": 200}})";
    const Said said = carom_tool({"tunnel", folder / "bullet.json", "--json"});
    REQUIRE(said.code == exit_ok);
    const json result = json::parse(said.out);
    CHECK(result["scene"] == "Shot");
    REQUIRE(result["rows"].size() == 4);
    for (const json& row : result["rows"]) {
        CHECK(row["trials"] == 200);
        CHECK(row["target"] == "plate");
        const bool must_miss = row["method"] == "velocity" && row["speed"] == 500;  // 98.7 % of them
        CHECK((row["tunnelled"] > 180) == must_miss);
        if (!must_miss) CHECK(row["tunnelled"] == 0);
    }
    const Said asked = carom_tool({"tunnel", folder / "bullet.json", "--methods", "event,toi"});
    CHECK_THAT(asked.out, Contains("Absent: event, its run is the truth of a scene"));
}

TEST_CASE("tunnel SCENE --bisect finds critical speeds, and -o writes throws of that scene that run as thrown", "[cli]")
{
    const Folder folder;
    std::ofstream(folder / "bullet.json") << R"({"format": "carom-scene/1", "name": "Shot", "end_time": 1,
 "gravity": [0, 0, -1e-3],
 "spheres": [{"id": "bullet", "radius": 0.1, "position": [-5, 0, 0], "velocity": [10, 0, 0]}],
 "planes": [{"id": "plate", "normal": [1, 0, 0], "offset": 0, "thickness": 0.02}]})";
    const Said said = carom_tool({"tunnel", folder / "bullet.json", "--methods", "velocity", "--bisect", "--speed",
                                  "500", "--dt", "1/60", "--trials", "50", "--json", "-o", folder / "out"});
    REQUIRE(said.code == exit_ok);
    const json result = json::parse(said.out);
    REQUIRE(result["critical"].size() == 2);
    for (const json& critical : result["critical"]) {
        CHECK(critical["end"] == "found");
        CHECK(critical["critical_speed"] == Approx(0.11 * 60).epsilon(0.02));
    }
    for (const char* file : {"out/throws/velocity.json", "out/throws/velocity-parabola.json"}) {
        CAPTURE(file);
        const json scene = json::parse(folder.read(file));
        CHECK(scene["gravity"][2] == -1e-3);
        CHECK(scene["spheres"][0]["id"] == "bullet");
        const auto impacts = [&](std::vector<std::string> more) {
            std::vector<std::string> args{"run", folder / file, "--json"};
            args.insert(args.end(), more.begin(), more.end());
            return json::parse(carom_tool(args).out)["counts"]["impacts"].get<int>();
        };
        CHECK(impacts({}) == 0);
        CHECK(impacts({"--method", "event"}) == 1);
    }
    CHECK_THAT(folder.read("out/report.html"), Contains("A throw of carom tunnel: the contact is at"));
}

TEST_CASE("tunnel says what is wrong, where, and what would be right", "[cli]")
{
    const Folder folder;
    const auto refused = [](const std::vector<std::string>& args, int code, const std::string& words) {
        const Said said = carom_tool(args);
        CHECK(said.code == code);
        CHECK(said.out.empty());
        CHECK_THAT(said.err, Contains(words));
    };
    refused({"tunnel", "--methods", "velocty"}, exit_usage,
            "--methods: unknown method \"velocty\" (did you mean \"velocity\"?");
    refused({"tunnel", "--methods", "fcl"}, exit_usage, "fcl_naive");
    refused({"tunnel", "--target", "plane"}, exit_usage, "--target: unknown target \"plane\" (did you mean \"plate\"?");
    refused({"tunnel", "--speed", "0"}, exit_usage, "--speed: 0 in \"0\" must be > 0");
    refused({"tunnel", "--thickness", "-1"}, exit_usage, "--thickness: -1 in \"-1\" must be >= 0");
    refused({"tunnel", "--trials", "0"}, exit_usage, "--trials: \"0\" is not within 1");
    refused({"tunnel", "--bisect", "--offset", "1"}, exit_usage, "--offset: 1 is no hit");
    refused({"tunnel", "--set", "/gravity=[0,0,0]"}, exit_usage, "--set: there is no scene to change");
    refused({"tunnel", "bullet", "--radius", "1"}, exit_usage, "--radius: the scene gives the bodies");
    refused({"tunnel", "--bisect", "--target", "wall"}, exit_usage, "--bisect: nothing is behind a wall");
    refused({"tunnel", "no_such_scene"}, exit_bad_input, "no_such_scene");
    std::ofstream(folder / "still.json") << R"({"format": "carom-scene/1", "end_time": 1,
 "spheres": [{"id": "ball", "radius": 0.1, "position": [0, 0, 1]}]})";
    refused({"tunnel", folder / "still.json"}, exit_bad_input, "still.json: /spheres: none of them moves at the start");
    std::ofstream(folder / "wrong.json")
        << R"({"format": "carom-scene/1", "end_time": 1, "tunnel": {"methods": ["pdb"]},
 "spheres": [{"id": "ball", "radius": 0.1, "position": [0, 0, 1], "velocity": [1, 0, 0]}]})";
    refused({"tunnel", folder / "wrong.json"}, exit_bad_input, "/tunnel/methods: unknown method \"pdb\"");
}

TEST_CASE("collision libraries are thrown at walls as at plates, and miss none; libccd finds the time", "[cli]")
{
    const Said said =
        carom_tool({"tunnel", "--target", "wall", "--radius", "0.1", "--dt", "1/60", "--speed", "1,31.6,1e4",
                    "--methods", "fcl_naive,fcl_advancement,libccd_advancement", "--trials", "50", "--json"});
    REQUIRE(said.code == exit_ok);
    const json result = json::parse(said.out);
    CHECK(result["rows"].size() + result["absent"].size() > 0);
    for (const json& row : result["rows"]) {
        CAPTURE(row["method"], row["variant"], row["speed"]);
        CHECK(row["tunnelled"] == 0);
        CHECK(row["wrong"] == 0);
        if (row["method"] == "libccd_advancement") CHECK(row["worst_error"] < 1e-8);
    }
}

TEST_CASE("tunnel stops at its time limit with whole files", "[cli]")
{
    const Folder folder;
    const Said said = carom_tool(
        {"tunnel", "--methods", "velocity", "--trials", "1000000", "--max-seconds", "0.2", "-q", "-o", folder / "out"});
    CHECK(said.code == exit_limit);
    const json result = json::parse(folder.read("out/tunnel.json"));
    CHECK(result["stopped"] == "time_limit");
    CHECK(result["interrupted"] == true);
    for (const json& row : result["rows"]) CHECK(row["trials"] == 1'000'000);
    CHECK(folder.read("out/tunnel.csv").back() == '\n');
}

TEST_CASE("tunnel -h has examples", "[cli]")
{
    const Said said = carom_tool({"tunnel", "-h"});
    CHECK(said.code == exit_ok);
    CHECK_THAT(said.out,
               Contains("Examples:") && Contains("carom tunnel --bisect -o out/tunnel") && Contains("--max-seconds"));
    CHECK_THAT(carom_tool({"-h"}).out, Contains("tunnel"));
}
