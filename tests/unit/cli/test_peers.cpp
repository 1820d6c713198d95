#include "ball_folder.hpp"
#include "cli/exit_codes.hpp"
#include "support/carom_tool.hpp"
#include "unit/peers/script.hpp"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

#include <cstdlib>

using namespace carom::cli;
using namespace carom::test;
using Catch::Matchers::Contains;
using nlohmann::json;

namespace {

/// Programs of engines are looked for in this folder as long as it lives.
class PeerFolder {
public:
    explicit PeerFolder(const std::filesystem::path& folder) { ::setenv("CAROM_PEERS", folder.c_str(), 1); }
    ~PeerFolder() { ::unsetenv("CAROM_PEERS"); }
    PeerFolder(const PeerFolder&) = delete;
    PeerFolder& operator=(const PeerFolder&) = delete;
};

const char* const flight = R"({"format": "carom-scene/1", "end_time": 1, "name": "Flight",
 "spheres": [{"id": "s0", "radius": 0.1, "position": [0, 0, 0], "velocity": [1, 0, 0]}],
 "planes": [{"id": "plate", "normal": [1, 0, 0], "offset": 0.5, "thickness": 0.02}]})";

}  // namespace

TEST_CASE("compare has rows of other engines that are asked for, with their settings in table, verdict and files",
          "[cli]")
{
    const Script script(along_x, "carom_peer_ode");
    const PeerFolder peers(script.folder());
    const std::string scene = (script.folder() / "flight.json").string(), out = (script.folder() / "out").string();
    std::ofstream(scene) << flight;
    const Said said = carom_tool({"compare", scene, "--methods", "event,ode", "--dt", "1/60", "--json", "-o", out});
    REQUIRE(said.code == exit_ok);
    const json result = json::parse(said.out);
    REQUIRE(result["rows"].size() == 2);
    CHECK(result["rows"][1]["method"] == "ode");
    CHECK(result["rows"][1]["peer_settings"] == "Walker 1.0, as it comes");
    CHECK(result["rows"][1]["missed_impacts"].is_null());
    CHECK(result["rows"][1]["position_max"] > 1);
    const Said table = carom_tool({"compare", scene, "--methods", "event,ode", "--dt", "1/60", "-q", "-o", out});
    CHECK_THAT(table.out, Contains("\node: Walker 1.0, as it comes\n") && Contains("ode is Walker 1.0, as it comes; "));
}

TEST_CASE("an engine that is not there is no row, and who asked for it reads how to get it", "[cli]")
{
    const Script script(along_x, "carom_peer_ode");
    const PeerFolder peers(script.folder());
    const std::string scene = (script.folder() / "flight.json").string(), out = (script.folder() / "out").string();
    std::ofstream(scene) << flight;
    const Said asked = carom_tool({"compare", scene, "--methods", "event,bullet", "--dt", "1/60", "-o", out});
    CHECK(asked.code == exit_ok);
    CHECK_THAT(asked.err, Contains("bullet: its program carom_peer_bullet is not there (install libbullet-dev"));
    CHECK_THAT(carom_tool({"compare", scene, "--methods", "event", "-o", out}).err, !Contains("carom_peer"));
    const Said thrown = carom_tool({"tunnel", scene, "--methods", "velocity,bullet", "--trials", "5"});
    CHECK_THAT(thrown.out, Contains("Absent: bullet, its program carom_peer_bullet is not there"));
    CHECK_THAT(carom_tool({"tunnel", scene, "--trials", "5"}).out, !Contains("carom_peer"));
}

TEST_CASE("engines that know no drag are refused with it", "[cli]")
{
    const Script script(along_x, "carom_peer_ode");
    const PeerFolder peers(script.folder());
    const std::string scene = (script.folder() / "flight.json").string();
    std::ofstream(scene) << flight;
    for (const char* command : {"compare", "tunnel"}) {
        const Said said = carom_tool({command, scene, "--set", "/drag=1", "--methods", "velocity,ode"});
        CHECK(said.code == exit_bad_input);
        CHECK_THAT(said.err, Contains("flight.json: /drag: engines beside have none"));
    }
}

TEST_CASE("tunnel throws with an engine that flies through: every throw tunnels, and its scene is written", "[cli]")
{
    const Script script(along_x, "carom_peer_ode");
    const PeerFolder peers(script.folder());
    const std::string scene = (script.folder() / "flight.json").string(), out = (script.folder() / "out").string();
    std::ofstream(scene) << flight;
    const Said said = carom_tool({"tunnel", scene, "--methods", "ode", "--speed", "1", "--trials", "20", "--bisect",
                                  "--dt", "1/60", "--json", "-o", out});
    REQUIRE(said.code == exit_ok);
    const json result = json::parse(said.out);
    CHECK(result["rows"][0]["tunnelled"] == 20);
    CHECK(result["critical"][0]["end"] == "below");
    CHECK(result["engines"][0]["settings"] == "Walker 1.0, as it comes");
    CHECK(std::filesystem::exists(script.folder() / "out/throws/ode.json"));
}
