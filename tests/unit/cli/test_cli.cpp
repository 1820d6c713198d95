#include "ball_folder.hpp"
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"
#include "io/compare_files.hpp"
#include "io/events_csv.hpp"
#include "support/carom_tool.hpp"

#include <carom/io.hpp>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace carom::cli;
using carom::test::carom_tool;
using carom::test::Folder;
using carom::test::Said;
using Catch::Matchers::Contains;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_CASE("run says what happened, as a table or as JSON and nothing else", "[cli]")
{
    const Folder folder;
    const Said table = carom_tool({"run", folder / "ball.json"});
    CHECK(table.code == exit_ok);
    CHECK_THAT(table.out, Contains("reached_end") && Contains("impacts") && Contains("for the whole command"));
    CHECK(table.err.empty());
    const Said data = carom_tool({"run", folder / "ball.json", "--json"});
    CHECK(data.code == exit_ok);
    CHECK(json::parse(data.out)["format"] == "carom-run/1");
    CHECK(json::parse(data.out)["counts"]["impacts"] == 1);  // 0.4515, the next at 1.174
}

TEST_CASE("run writes its result and its events", "[cli]")
{
    const Folder folder;
    const Said said = carom_tool(
        {"run", folder / "ball.json", "-o", folder / "deep/out", "--events", folder / "events.csv", "--json"});
    CHECK(said.code == exit_ok);
    CHECK(json::parse(folder.read("deep/out/run.json")) == json::parse(said.out));
    std::istringstream events(folder.read("events.csv"));
    std::string line;
    std::getline(events, line);
    CHECK(line == "t,kind,a,b,nx,ny,nz,jx,jy,jz");
    std::getline(events, line);
    CHECK_THAT(line, Catch::Matchers::StartsWith("0.4515236409857") && Contains(",impact,ball,floor,0,0,1,0,0,"));
    CHECK_FALSE(std::getline(events, line));
}

TEST_CASE("run says what has no effect, how a few spheres end, and what cannot be", "[cli]")
{
    const Folder folder;
    const Said said = carom_tool({"run", folder / "ball.json", "--dt", "0.1"});
    CHECK(said.code == exit_ok);
    CHECK_THAT(said.err, Contains("carom: note: --dt has no effect"));
    CHECK_THAT(said.out, Contains("ball at (0.2, 0, "));
    CHECK(carom_tool({"run", folder / "ball.json", "--dt", "0.1", "-q"}).err.empty());
    CHECK_THAT(carom_tool({"run", folder / "ball.json", "--set", "/materials/ruber/restitution=0.5"}).err,
               Contains("no body is of the material \"ruber\" (did you mean \"rubber\"?)"));
    const Said wild = carom_tool({"run", folder / "ball.json", "--method", "velocity", "--dt", "10", "--until", "10"});
    CHECK_THAT(wild.out, Contains("1 behind a plane or nowhere: ball"));
    const Said growing =
        carom_tool({"run", folder / "ball.json", "--method", "velocity", "--dt", "10", "--until", "20"});
    CHECK_THAT(growing.out, Contains("energy drift     GREW by 1.809e+04"));
}

TEST_CASE("events go into a folder that is there", "[cli]")
{
    const Folder folder;
    const Said said = carom_tool({"run", folder / "ball.json", "--events", folder / "none/events.csv"});
    CHECK(said.code == exit_bad_input);
    CHECK_THAT(said.err, Contains("no such folder: " + folder / "none"));
    CHECK_FALSE(fs::exists(folder / "none"));
    CHECK_THAT(carom_tool({"run", folder / "ball.json", "--method", "pdb"}).err, Contains("did you mean \"pbd\"?"));
}

TEST_CASE("events go to stdout for -, and the table to stderr", "[cli]")
{
    const Folder folder;
    const Said said = carom_tool({"run", folder / "ball.json", "--events", "-"});
    CHECK(said.code == exit_ok);
    std::istringstream lines(said.out);
    std::string head, event, more;
    std::getline(lines, head);
    CHECK(head == carom::io::events_csv_header);
    std::getline(lines, event);
    CHECK_THAT(event, Contains(",impact,ball,floor,"));
    CHECK_FALSE(std::getline(lines, more));
    CHECK_THAT(said.err, Contains("reached_end"));
    CHECK_FALSE(fs::exists("-"));
    const Said quiet = carom_tool({"run", folder / "ball.json", "--events", "-", "-q"});
    CHECK(quiet.out == said.out);
    CHECK(quiet.err.empty());
    const Said both = carom_tool({"run", folder / "ball.json", "--events", "-", "--json"});
    CHECK(both.code == exit_usage);
    CHECK(both.out.empty());
    CHECK_THAT(both.err, Contains("--events - and --json both write to stdout"));
}

TEST_CASE("a full disk is named, whichever file it fills", "[cli]")
{
    const Folder folder;
    const Said events = carom_tool({"run", folder / "ball.json", "--events", "/dev/full"});
    CHECK(events.code == exit_bad_input);
    CHECK_THAT(events.err, Contains("/dev/full: cannot be written: No space left on device"));
    fs::create_directories(folder / "out/run.json.part");  // in the way
    const Said result = carom_tool({"run", folder / "ball.json", "--method", "pbd", "-o", folder / "out", "-q"});
    CHECK(result.code == exit_bad_input);
    CHECK_THAT(result.err, Contains("run.json.part: cannot be written: Is a directory"));
}

TEST_CASE("a sphere that is lifted out of a plane it began in says so, with the energy that gives it", "[cli]")
{
    const Folder folder;
    const auto run = [&](const std::string& z, const std::string& v, bool as_json) {
        return carom_tool({"run", folder / "ball.json", "--allow-overlap", "--set",
                           "/spheres/0/position=[0,0," + z + "]", "--set", "/spheres/0/velocity=[0,0," + v + "]",
                           as_json ? "--json" : "--no-progress"});
    };
    for (const std::string v : {"0", "-0.01"}) {
        CAPTURE(v);
        const Said table = run("0.06", v, false);
        CHECK(table.code == exit_ok);
        CHECK_THAT(table.err, Contains("note: \"ball\" began inside plane \"floor\" and was lifted out of it by 0.04"));
        CHECK_THAT(table.out, !Contains("this run is wrong"));
        const json lifted = json::parse(run("0.06", v, true).out)["energy"]["lifted"];
        REQUIRE(lifted.size() == 1);
        CHECK(lifted[0]["id"] == "ball");
        CHECK(lifted[0]["plane"] == "floor");
        CHECK(lifted[0]["depth"].get<double>() == Approx(0.04).epsilon(1e-3));
        CHECK(lifted[0]["energy"].get<double>() == Approx(9.81 * 0.04).epsilon(1e-3));
    }
    CHECK(json::parse(run("0.1", "0", true).out)["energy"]["lifted"].empty());
    CHECK(json::parse(run("1.1", "0", true).out)["energy"]["lifted"].empty());
    const Said compared =
        carom_tool({"compare", folder / "ball.json", "--allow-overlap", "--repeats", "1", "-o", folder / "c", "--set",
                    "/spheres/0/position=[0,0,0.06]", "--set", "/spheres/0/velocity=[0,0,0]"});
    CHECK_THAT(compared.err,
               Contains("note: event: \"ball\" began inside plane \"floor\"") && !Contains("pbd: \"ball\""));
    const json rows = json::parse(folder.read("c/compare.json"))["rows"];
    CHECK(rows[0]["lifted"][0]["energy"].get<double>() == Approx(9.81 * 0.04).epsilon(1e-3));
    CHECK(rows[1]["lifted"].empty());
    // Twelve in a row, each sunk by 0.02: ten are named.
    const Said many = carom_tool(
        {"run", folder / "ball.json", "--allow-overlap", "--set", "/spheres=[]", "--set",
         R"(/fill=[{"pattern": "line", "count": 12, "radius": 0.1, "gap": 1, "origin": [0, 0, 0.08], "material": "rubber"}])"});
    CHECK_THAT(many.err, Contains("\"fill-0/9\" began inside") && !Contains("\"fill-0/10\"") &&
                             Contains("so were 2 more, which gave 0.3924"));
    const Said leaves = run("0.06", "2", false);  // flies out on its own, as high as its speed takes it
    CHECK_THAT(leaves.err, !Contains("lifted"));
}

TEST_CASE("a run that met what it cannot resolve says how to go on, and compare exits with 1", "[cli]")
{
    const Folder folder;
    // A light ball of a heap squeezed between the floor and a heavy one: impacts accumulate, and the guard is off.
    const std::string jam =
        R"(/spheres=[{"radius": 0.1, "mass": 1e-6, "position": [0, 0, 0.1005], "material": "lossy"},
        {"radius": 0.1, "mass": 1e6, "position": [0, 0, 1.301], "velocity": [0, 0, -1], "material": "lossy"}])";
    const std::string heap =
        R"(/fill=[{"pattern": "line", "count": 12, "radius": 0.1, "gap": 5e-5, "origin": [0.20005, 0, 0.1005], "material": "lossy"}])";
    const std::vector<std::string> set{"--set",   R"(/materials={"lossy": {"restitution": 0.999}})",
                                       "--set",   heap,
                                       "--set",   "/guard=off",
                                       "--set",   R"(/rest={"closing_speed": 0, "window": 0, "numeric_step": 0.01})",
                                       "--set",   R"(/planes=[{"normal": [0, 0, 1], "offset": 0}])",
                                       "--set",   "/gravity=[0,0,0]",
                                       "--set",   jam,
                                       "--until", "2.5"};
    std::vector<std::string> args{"run", folder / "ball.json"};
    args.insert(args.end(), set.begin(), set.end());
    const Said run = carom_tool(args);
    CHECK(run.code == exit_failed);
    CHECK_THAT(run.err, Contains("unresolved") && Contains("note: what was computed up to there is valid: --until "));
    args[0] = "compare";
    for (const std::string& word : {std::string("-o"), folder / "c", std::string("--repeats"), std::string("1")})
        args.push_back(word);
    const Said compared = carom_tool(args);
    CHECK(compared.code == exit_failed);
    CHECK_THAT(compared.err, Contains("carom: event: unresolved: impacts of") && Contains("--until"));
    CHECK_THAT(compared.out, Contains("unresolved at 1") && !Contains("x event\n") && Contains("up to t = 1"));
    CHECK(json::parse(folder.read("c/compare.json"))["rows"].size() == 2);
}

TEST_CASE("limits exit with 5 and leave a valid result", "[cli]")
{
    const Folder folder;
    const Said said = carom_tool({"run", folder / "ball.json", "--max-events", "1", "--until", "3", "--json"});
    CHECK(said.code == exit_limit);
    CHECK(json::parse(said.out)["status"] == "event_limit");
    CHECK_THAT(said.err, Contains("event_limit"));
}

TEST_CASE("what cannot be read exits with 3, what cannot be understood with 2", "[cli]")
{
    const Folder folder;
    folder.write("broken.json", "{\"format\": \"carom-scene/1\",");
    folder.write("wrong.json", R"({"format": "carom-scene/1", "end_time": -1})");
    for (const char* file : {"broken.json", "wrong.json", "missing.json"}) {
        const Said said = carom_tool({"run", folder / file});
        CAPTURE(file);
        CHECK(said.code == exit_bad_input);
        CHECK_FALSE(said.err.empty());
        CHECK(said.out.empty());
    }
    CHECK(carom_tool({"run", folder / "ball.json", "--dt", "0"}).code == exit_usage);
    CHECK(carom_tool({"run", folder / "ball.json", "--method", "magic"}).code == exit_usage);
    CHECK(carom_tool({"report", folder / "nothing"}).code == exit_bad_input);
    folder.write("file", "");
    CHECK(carom_tool({"run", folder / "ball.json", "-o", folder / "file"}).code == exit_bad_input);
    CHECK(carom_tool({"run", folder / "ball.json", "--events", folder / "file/events.csv"}).code == exit_bad_input);
}

TEST_CASE("compare writes its files, a table with a verdict, and a page that report can join with others", "[cli]")
{
    const Folder folder;
    const Said table = carom_tool({"compare", folder / "ball.json", "--repeats", "1", "-o", folder / "a"});
    CHECK(table.code == exit_ok);
    CHECK_THAT(table.out, Contains("method") && Contains("1/60") && Contains("Use event: it is off by at most") &&
                              Contains("report.html"));
    CHECK_THAT(table.out, Contains("Tolerance: position error 1 mm (0.01 of the smallest radius") &&
                              Contains("within 1 mm") &&
                              Contains("found, late, missed, wrong: of the impacts audited"));
    std::istringstream csv(folder.read("a/compare.csv"));
    std::string line;
    std::getline(csv, line);
    CHECK(line == carom::io::compare_csv_header());
    const json rows = json::parse(folder.read("a/compare.json"))["rows"];
    REQUIRE(rows.size() == 3);
    CHECK(rows[1]["integrator"] == "euler");
    CHECK(rows[2]["integrator"] == "parabola");
    CHECK_THAT(folder.read("a/report.html"), Contains("<html") && Contains("carom-page/1"));

    const Said data = carom_tool(
        {"compare", folder / "ball.json", "--methods", "event", "--repeats", "1", "-o", folder / "b", "--json"});
    CHECK(json::parse(data.out)["format"] == "carom-compare/1");
    const Said joined = carom_tool({"report", folder / "a", folder / "b", "-o", folder / "all.html"});
    CHECK(joined.code == exit_ok);
    CHECK(joined.out == folder / "all.html" + std::string("\n"));
    // Two comparisons of one scene are told apart.
    CHECK_THAT(folder.read("all.html"),
               Contains("Ball (" + folder / "a" + ")") && Contains("Ball (" + folder / "b" + ")"));
    CHECK(folder.read("all.html").size() > folder.read("a/report.html").size());
}

TEST_CASE("scenes are listed and shown", "[cli]")
{
    const Folder folder;
    const Said shown = carom_tool({"scenes", "show", folder / "ball.json"});
    CHECK(shown.code == exit_ok);
    CHECK_THAT(shown.out, Contains("Ball") && Contains("floor"));
    CHECK(json::parse(carom_tool({"scenes", "show", folder / "ball.json", "--json"}).out)["name"] == "Ball");
    CHECK(json::parse(carom_tool({"scenes", "--json"}).out)["scenes"].is_array());
}

TEST_CASE("stress says who passes and why others fail, in a table, as JSON, in files and on a page", "[cli]")
{
    const Folder folder;
    const Said table = carom_tool({"stress", "ulp_gap", "--methods", "event,naive", "-o", folder / "s"});
    CHECK(table.code == exit_ok);
    CHECK_THAT(table.out, Contains("ulp_gap  pass") && Contains("FAIL") &&
                              Contains("naive: ulp_gap_soft_floor: made ") && Contains("passed if") &&
                              Contains("event passes 1 of 1") && Contains("naive passes 0 of 1") &&
                              Contains("report.html"));
    CHECK_THAT(folder.read("s/stress.csv"), Contains("ulp_gap,,event,true,") && Contains("ulp_gap,,naive,false,"));
    CHECK_THAT(folder.read("s/report.html"), Contains("<html") && Contains("carom-stress-page/1"));
    const json data = json::parse(folder.read("s/stress.json"));
    CHECK(data["format"] == "carom-stress/1");
    CHECK(data["event_passes"] == true);
    const json& naive = data["cases"][0]["results"][1];
    CHECK(naive["symptom"] == "invented");
    CHECK(naive["scene"] == "ulp_gap_soft_floor");
    CHECK(naive["runs"].size() == 6);
    CHECK(json::parse(carom_tool({"stress", "--json", "--methods", "pbd", "speed", "zeno"}).out)["cases"].size() == 2);

    const Said unknown = carom_tool({"stress", "grasing"});
    CHECK(unknown.code == exit_usage);
    CHECK_THAT(unknown.err, Contains("did you mean \"grazing\""));
    CHECK(carom_tool({"stress", "--methods", "magic"}).code == exit_usage);
}

TEST_CASE("stress lists its cases, says which wait for something, and runs them without being strict", "[cli]")
{
    const Said list = carom_tool({"stress", "--list"});
    CHECK(list.code == exit_ok);
    CHECK_THAT(list.out, Contains("grazing") && Contains("leaning_least (waits)") && !Contains("passed if"));
    const json cases = json::parse(carom_tool({"stress", "--list", "--json"}).out)["cases"];
    CHECK(cases.size() > 30);
    const Said waiting = carom_tool({"stress", "leaning_least", "--methods", "event"});
    CHECK(waiting.code == exit_ok);
    CHECK_THAT(waiting.out, Contains("FAIL") && Contains("waits for") && Contains("event passes 0 of 0"));
}

TEST_CASE("run and explain say how several contacts, rest and accumulating impacts are answered", "[cli]")
{
    const Folder folder;
    const std::vector<std::string> set{"--set", "/impact={\"operator\":\"lcp\",\"law\":\"poisson\"}",
                                       "--set", "/guard=off",
                                       "--set", "/rest={\"numeric_step\":0.125}"};
    std::vector<std::string> args{"explain", folder / "ball.json"};
    args.insert(args.end(), set.begin(), set.end());
    const Said text = carom_tool(args);
    CHECK_THAT(text.out, Contains("impact          lcp (poisson, exact), tie 1e-12 r") &&
                             Contains("rest            policy contact; closing speed 0.00443, window 0.000903, numeric "
                                      "step 0.125, gap tolerance 1e-10") &&
                             Contains("guard           off"));
    args.push_back("--json");
    const json said = json::parse(carom_tool(args).out);
    CHECK(said["impact"] == json{{"operator", "lcp"},
                                 {"tie", nullptr},
                                 {"on_cap", "accept"},
                                 {"law", "poisson"},
                                 {"solver", "exact"},
                                 {"sweeps", 100}});
    CHECK(said["rest"]["policy"] == "contact");
    CHECK(said["rest"]["numeric_step"] == 0.125);
    CHECK(said["guard"] == json{{"on", false}, {"impacts", 100}, {"window", 0.125}, {"fallback", "moreau"}});

    const Said run =
        carom_tool({"run", folder / "ball.json", "--impact", "jacobi", "--guard", "pbd", "-v", "--no-progress"});
    CHECK(run.code == exit_ok);
    CHECK_THAT(run.err, Contains("impact: jacobi") && Contains("then pbd for one window"));
    CHECK(carom_tool({"run", folder / "ball.json", "--impact", "jacoby"}).code == exit_usage);
}
