#include "cli/toi_command.hpp"

#include "cli/arguments.hpp"

#include <catch2/catch.hpp>

#include <sstream>

using namespace carom::cli;

TEST_CASE("every line is answered in order, bad ones among good ones", "[toi]")
{
    const std::string good =
        R"({"a": {"p": [0,0,0], "v": [1,0,0], "r": 1}, "b": {"p": [10,0,0], "v": [-1,0,0], "r": 2}})";
    std::istringstream in(good + "\nnonsense\n" + good);
    std::ostringstream out;
    serve_toi(in, out);
    std::istringstream answers(out.str());
    std::string first, second, third, more;
    std::getline(answers, first);
    std::getline(answers, second);
    std::getline(answers, third);
    CHECK(
        first ==
        R"({"status":"impact","t":3.5,"lo":3.4999999999999996,"hi":3.5000000000000004,"normal":[-1,0,0],"approach_speed":2,"level":0})");
    CHECK(second.starts_with(R"({"status":"error","message":)"));
    CHECK(third == first);
    CHECK_FALSE(std::getline(answers, more));
}

TEST_CASE("toi is a command with an example in its help", "[toi]")
{
    const ParseResult parsed = parse_arguments({"toi"});
    REQUIRE(parsed.arguments);
    CHECK(parsed.arguments->command == Command::toi);
    CHECK(parse_arguments({"toi", "-h"}).out.find("carom toi") != std::string::npos);
    CHECK_FALSE(parse_arguments({"toi", "more"}).arguments);
}
