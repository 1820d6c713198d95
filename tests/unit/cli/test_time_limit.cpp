#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "cli/session.hpp"
#include "support/carom_tool.hpp"

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

using namespace carom;
using namespace carom::cli;
using carom::test::carom_tool;
using carom::test::Said;
using Catch::Matchers::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// No command is done by then.
const std::vector<std::string> at_once{"--max-seconds", "1e-9"};

std::vector<std::string> with(std::vector<std::string> args, const std::vector<std::string>& more)
{
    args.insert(args.end(), more.begin(), more.end());
    return args;
}

}  // namespace

TEST_CASE("no command takes a limit that is none", "[time_limit]")
{
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{{"run", "cradle"},
                                                                                         {"compare", "cradle"},
                                                                                         {"check", "cradle"},
                                                                                         {"stress"},
                                                                                         {"verify", "x"},
                                                                                         {"report", "x"}})
        for (const char* wrong : {"0", "-1", "soon"}) {
            CAPTURE(command.front(), wrong);
            const Said said = carom_tool(with(command, {"--max-seconds", wrong}));
            CHECK(said.code == exit_usage);
            CHECK_THAT(said.err, Contains("--max-seconds"));
        }
}

TEST_CASE("the limit counts from the start of the command, reading included", "[time_limit]")
{
    for (const char* command : {"run", "compare", "check"}) {
        CAPTURE(command);
        const Said said = carom_tool(with({command, "gas_1000"}, at_once));
        CHECK(said.code == exit_limit);
        CHECK(said.out.empty());
        CHECK_THAT(said.err, Contains("the limit of 1e-09 s for the whole command, while it was read"));
    }
}

TEST_CASE("a limit that the scene gives holds for the command, too", "[time_limit]")
{
    // Reading is over by then; the run would take minutes.
    const Said run =
        carom_tool({"run", "gas_1000", "--until", "1e6", "--set", "/run={\"max_seconds\": 0.2}", "--json"});
    CHECK(run.code == exit_limit);
    const json result = json::parse(run.out);
    CHECK(result["status"] == "time_limit");
    CHECK(result["command_seconds"] >= 0.2);
    CHECK_THAT(result["message"].get<std::string>(), Contains("the limit of 0.2 s for the whole command"));
    const Said typed =
        carom_tool({"run", "cradle", "--max-seconds", "1000", "--set", "/run={\"max_seconds\": 1e-9}", "--json"});
    CHECK(typed.code == exit_ok);
}

TEST_CASE("what a limit leaves of stress and compare is a valid result that says so", "[time_limit]")
{
    const Said stress = carom_tool(with({"stress", "--json"}, at_once));
    CHECK(stress.code == exit_limit);
    CHECK(json::parse(stress.out)["stopped"] == "time_limit");
    CHECK(json::parse(stress.out)["cases"].empty());

    const fs::path folder = fs::temp_directory_path() / ("carom-limit-" + std::to_string(::getpid()));
    const Said compare = carom_tool({"compare", "gas_1000", "--until", "100", "--set", "/compare/max_seconds=0.5",
                                     "--json", "-o", folder.string()});
    CHECK(compare.code == exit_limit);
    CHECK(json::parse(compare.out)["stopped"] == "time_limit");
    for (const char* file : {"compare.csv", "compare.json", "page.json", "report.html"})
        CHECK(fs::exists(folder / file));
    CHECK(carom_tool(with({"report", folder.string()}, at_once)).code == exit_limit);
    fs::remove_all(folder);
}

TEST_CASE("the command's seconds contain those of its run", "[time_limit]")
{
    const json run = json::parse(carom_tool({"run", "gas_1000", "--until", "0.05", "--json"}).out);
    CHECK(run["command_seconds"] > run["wall_seconds"]);
    CHECK(run["command_cpu_seconds"] > run["cpu_seconds"]);
    const json check = json::parse(carom_tool({"check", "cradle", "--json"}).out);
    CHECK(check["stopped"].is_null());
    CHECK(check["command_cpu_seconds"] > check["scenes"][0]["cpu_seconds"]);
}

TEST_CASE("the first reason to end stays, and an outcome is told by it", "[time_limit]")
{
    CommandWatch watch(1e-9);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    CHECK_FALSE(watch.ended());
    CHECK_FALSE(watch.keep_going());
    watch.limit(1000);
    CHECK_FALSE(watch.keep_going());
    REQUIRE(watch.ended() == Status::time_limit);
    Outcome outcome;
    watch.name_reason(outcome);
    CHECK(outcome.status == Status::reached_end);
    outcome.status = Status::interrupted;
    watch.name_reason(outcome);
    CHECK(outcome.status == Status::time_limit);
}

TEST_CASE("a progress line shows a stage's own rate, and nothing in the first second", "[time_limit]")
{
    std::ostringstream out, err, silent;
    const Console console{out, err, true}, other{out, silent, true};
    GlobalArguments quiet, without;
    quiet.quiet = true;
    without.no_progress = true;
    ProgressLine line(console, {}), quiet_line(other, quiet), no_line(other, without);
    const Progress begun{"reference", "reference", 0, 0, "s"}, half{"reference", "reference", 0.5, 2, "s"};
    line.show(begun);
    CHECK(err.str().empty());
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    for (ProgressLine* each : {&line, &quiet_line, &no_line}) each->show(half);
    CHECK_THAT(err.str(), Contains("reference: 50 %, ") && Contains(" s/s, ") && Contains(" s left"));
    CHECK(silent.str().empty());
    err.str("");
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    line.show({"methods", "pbd dt 1/60", 0, 0, "steps"});
    CHECK_THAT(err.str(), Contains("pbd dt 1/60: 0 %") && !Contains("left"));
}
