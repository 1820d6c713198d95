/// Commands that write and certify recordings.
#include "ball_folder.hpp"
#include "cli/exit_codes.hpp"
#include "support/carom_tool.hpp"

#include <carom/io.hpp>

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

using namespace carom::cli;
using carom::test::carom_tool;
using carom::test::Folder;
using carom::test::Said;
using Catch::Matchers::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("verify certifies a recorded run, refuses a damaged one, and tells what does not hold", "[cli]")
{
    const Folder folder;
    REQUIRE(carom_tool({"run", folder / "ball.json", "-o", folder / "run"}).code == exit_ok);
    for (const std::string& run : {folder / "run", folder / "run/run.carom"}) {
        const Said table = carom_tool({"verify", run});
        CHECK(table.code == exit_ok);
        CHECK(table.err.empty());
        CHECK_THAT(table.out, Contains("holds") && Contains("complete") && Contains("smallest gap"));
    }
    const json run = json::parse(folder.read("run/run.json")),
               data = json::parse(carom_tool({"verify", folder / "run", "--json"}).out);
    CHECK(data["format"] == "carom-verify/1");
    CHECK(data["holds"] == true);
    CHECK(data["event_hash"] == run["event_hash"]);
    CHECK(data["impulses"] == 1);
    CHECK(data["body_seconds"]["not_certified"] == 0);

    std::string bytes = folder.read("run/run.carom");
    bytes[bytes.find("carom-recording/3") + 3] ^= 1;
    folder.write("damaged.carom", bytes);
    const Said damaged = carom_tool({"verify", folder / "damaged.carom"});
    CHECK(damaged.code == exit_bad_input);
    CHECK_THAT(damaged.err, Contains("damaged"));
    CHECK(carom_tool({"verify", folder / "nothing"}).code == exit_bad_input);
    CHECK(carom_tool({"verify", folder / "ball.json"}).code == exit_bad_input);

    // A recording of a ball that falls through the floor, by a writer of its own.
    carom::Scene scene = carom::read_scene(folder / "ball.json");
    {
        carom::RecordingWriter writer(folder / "forged.carom", scene);
        carom::Observer observer;
        observer.on_frame = [&](const carom::RunFrame& frame) { writer.on_frame(frame); };
        bool first = true;
        observer.on_flight = [&](const carom::FlightRecord& flight) {
            if (first) writer.on_flight(flight);
            first = false;
        };
        carom::Outcome outcome = carom::simulate(scene, carom::EventDriven{}, {}, observer);
        writer.finish(outcome);
    }
    const Said forged = carom_tool({"verify", folder / "forged.carom"});
    CHECK(forged.code == exit_check_failed);
    CHECK_THAT(forged.out, Contains("DOES NOT HOLD"));
    CHECK_THAT(forged.err, Contains("overlap") && Contains("event hash"));
    CHECK(json::parse(carom_tool({"verify", folder / "forged.carom", "--json"}).out)["violations"][1]["b"] == "floor");
}

TEST_CASE("a discrete method has no flights to record, and says so", "[cli]")
{
    const Folder folder;
    const Said said = carom_tool({"run", folder / "ball.json", "--method", "pbd", "-o", folder / "run"});
    CHECK(said.code == exit_ok);
    CHECK_THAT(said.err, Contains("no flights to record"));
    CHECK_FALSE(fs::exists(folder / "run/run.carom"));
    CHECK(fs::exists(folder / "run/run.json"));
}
