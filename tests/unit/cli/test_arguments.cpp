#include "cli/arguments.hpp"
#include "cli/exit_codes.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::cli;
using Catch::Matchers::Contains;

namespace {

Arguments parsed(const std::vector<std::string>& args)
{
    const ParseResult result = parse_arguments(args);
    INFO(result.err);
    REQUIRE(result.arguments);
    return *result.arguments;
}

}  // namespace

TEST_CASE("options are read where the contract puts them, global ones anywhere", "[arguments]")
{
    const Arguments run =
        parsed({"--json", "run", "ball", "--method", "pbd", "--dt", "1/240", "--max-events", "10", "--final", "-o", "x",
                "--events", "e.csv", "--seed", "7", "-q", "--literal", "--allow-overlap"});
    CHECK(run.command == Command::run);
    CHECK(run.global.json);
    CHECK(run.global.quiet);
    CHECK(run.global.seed == std::optional<std::uint64_t>(7));
    CHECK(run.run.scene == "ball");
    CHECK(run.run.given == GivenOptions{{"method", "pbd"}, {"dt", "1/240"}, {"max_events", "10"}, {"literal", "true"}});
    CHECK(run.run.always_final);
    CHECK(run.run.allow_overlap);
    CHECK(run.run.out == "x");
    CHECK(run.run.events == "e.csv");

    const Arguments compare =
        parsed({"compare", "ball", "--methods", "event,pbd", "--dt", "1e-3:1e-1:log3", "--no-progress"});
    CHECK(compare.command == Command::compare);
    CHECK(compare.compare.given.at("methods") == "event,pbd");
    CHECK(compare.global.no_progress);
    CHECK(parsed({"report", "a", "b", "-o", "c.html"}).report.folders == std::vector<std::string>{"a", "b"});
    const Arguments stress = parsed({"stress", "zeno", "drift", "--methods", "event", "-o", "x"});
    CHECK(stress.command == Command::stress);
    CHECK(stress.stress.given.at("methods") == "event");
    CHECK(stress.stress.only == std::vector<std::string>{"zeno", "drift"});
    CHECK_FALSE(stress.stress.list);
    CHECK(parsed({"stress", "--list"}).stress.list);
    CHECK(stress.stress.out == "x");
    CHECK(parsed({"verify", "out/x"}).verify.run == "out/x");
    CHECK(parsed({"verify", "out/x", "--all-pairs"}).verify.all_pairs);
    CHECK(parsed({"scenes"}).scenes.show.empty());
    CHECK(parsed({"scenes", "list"}).command == Command::scenes);
    CHECK(parsed({"scenes", "show", "ball"}).scenes.show == "ball");
}

TEST_CASE("a seed is taken as it is written or refused, never as another number", "[arguments]")
{
    for (const char* word : {"0", "7", "10", "18446744073709551615"}) {
        CAPTURE(word);
        CHECK(std::to_string(parsed({"run", "ball", "--seed", word}).global.seed.value()) == word);
    }
    for (const char* word :
         {"-1", "+5", "010", "00", "0x10", "1e3", "1e23", "1.5", "18446744073709551616", " 5", "5 ", "seven"}) {
        CAPTURE(word);
        for (const auto& args : {std::vector<std::string>{"run", "ball", "--seed", word},
                                 std::vector<std::string>{"--seed", word, "check", "ball"},
                                 std::vector<std::string>{"run", "ball", std::string("--seed=") + word}}) {
            const ParseResult result = parse_arguments(args);
            CHECK_FALSE(result.arguments);
            CHECK(result.exit_code == exit_usage);
            CHECK_THAT(result.err, Contains("--seed: \"" + std::string(word) +
                                            "\" is no whole number from 0 to 18446744073709551615"));
        }
    }
}

TEST_CASE("an empty seed is none", "[arguments]")
{
    CHECK(parse_arguments({"run", "ball", "--seed", ""}).exit_code == exit_usage);
}

TEST_CASE("help and version succeed on stdout, at every level and with examples", "[arguments]")
{
    for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{{"-h"},
                                                                                      {"run", "-h"},
                                                                                      {"compare", "--help"},
                                                                                      {"report", "-h"},
                                                                                      {"check", "-h"},
                                                                                      {"explain", "-h"},
                                                                                      {"stress", "-h"},
                                                                                      {"verify", "-h"},
                                                                                      {"audit", "-h"},
                                                                                      {"scenes", "-h"},
                                                                                      {"scenes", "list", "-h"},
                                                                                      {"scenes", "show", "-h"}}) {
        const ParseResult result = parse_arguments(args);
        CHECK(result.exit_code == exit_ok);
        CHECK_FALSE(result.arguments);
        if (args.size() == 2) CHECK_THAT(result.out, Contains("\nExit: 0 "));
        CHECK_THAT(result.out, Contains("Examples:") && Contains("carom"));
        CHECK(result.err.empty());
    }
    const ParseResult version = parse_arguments({"--version"});
    CHECK(version.exit_code == exit_ok);
    CHECK_THAT(version.out, Contains("carom "));
}

TEST_CASE("usage errors exit with 2 and say so on stderr", "[arguments]")
{
    for (const std::vector<std::string>& args : std::vector<std::vector<std::string>>{{},
                                                                                      {"fly"},
                                                                                      {"run"},
                                                                                      {"run", "ball", "--speed", "3"},
                                                                                      {"run", "ball", "--dt"},
                                                                                      {"run", "a", "b"},
                                                                                      {"report"},
                                                                                      {"--seed", "x", "scenes"},
                                                                                      {"scenes", "show"}}) {
        const ParseResult result = parse_arguments(args);
        CHECK(result.exit_code == exit_usage);
        CHECK_FALSE(result.arguments);
        CHECK_FALSE(result.err.empty());
        CHECK(result.out.empty());
    }
}

TEST_CASE("usage errors name what is wrong and what was probably meant", "[arguments]")
{
    const auto said = [](const std::vector<std::string>& args) { return parse_arguments(args).err; };
    CHECK(said({"run", "ball", "--untill", "2"}) == "carom run: unknown option --untill (did you mean --until?)\n");
    CHECK(said({"run", "ball", "--untill=2"}) == "carom run: unknown option --untill (did you mean --until?)\n");
    CHECK(said({"compare", "ball", "--xyzzy"}) ==
          "carom compare: unknown option --xyzzy (carom compare -h lists them)\n");
    CHECK(said({"run", "ball", "--no-progres"}) ==
          "carom run: unknown option --no-progres (did you mean --no-progress?)\n");
    CHECK(said({"run"}) == "carom run: the scene is missing (carom run -h has examples)\n");
    CHECK(said({"scenes", "show"}) == "carom scenes show: the scene is missing (carom scenes show -h has examples)\n");
    CHECK(said({"run", "a", "b"}) == "carom run: unexpected argument \"b\" (carom run -h shows what it takes)\n");
    CHECK_THAT(said({}), Contains("carom: a command is missing (take: run, compare"));
    CHECK_THAT(said({"comprae", "ball"}), Contains("did you mean \"compare\"?"));
}

TEST_CASE("an unknown command is named", "[arguments]")
{
    CHECK_THAT(parse_arguments({"fly", "ball"}).err, Contains("unknown command \"fly\""));
}

TEST_CASE("--set keeps each assignment as typed, and takes one", "[arguments]")
{
    const std::vector<std::string> both{"/a/b=[1, 2]", "/c=x=y"};
    CHECK(parsed({"run", "--set", both[0], "--set=" + both[1], "ball"}).run.set == both);
    CHECK(parsed({"run", "--set", both[0], "ball"}).run.scene == "ball");
    CHECK(parsed({"compare", "ball", "--set", both[0]}).compare.set.size() == 1);
    CHECK(parsed({"check", "ball", "cradle", "--set", both[0]}).check.scenes.size() == 2);
}

TEST_CASE("scenes lists without a word, and validates any number", "[arguments]")
{
    CHECK(parsed({"scenes"}).scenes.action == ScenesAction::list);
    CHECK(parsed({"scenes", "show", "ball"}).scenes.action == ScenesAction::show);
    CHECK(parsed({"scenes", "schema"}).scenes.action == ScenesAction::schema);
    CHECK(parsed({"scenes", "validate"}).scenes.validate.empty());
    CHECK(parsed({"scenes", "validate", "a", "b"}).scenes.validate.size() == 2);
}

TEST_CASE("what belongs to later versions is refused and not in the help", "[arguments]")
{
    std::string help = parse_arguments({"-h"}).out;
    for (const char* command : {"run", "compare", "stress", "scenes"}) help += parse_arguments({command, "-h"}).out;
    for (const char* word : {"view", "export", "query", "--save-state", "--equilibrate"}) {
        CAPTURE(word);
        CHECK_THAT(help, !Contains(std::string(" ") + word + " "));
        const bool option = word[0] == '-';
        const ParseResult result = parse_arguments(option ? std::vector<std::string>{"run", "ball", word}
                                                          : std::vector<std::string>{word, "ball"});
        CHECK(result.exit_code == exit_usage);
        CHECK_THAT(result.err, Contains("not yet"));
    }
    CHECK(parsed({"run", "view"}).run.scene == "view");  // a scene may have any name
}
