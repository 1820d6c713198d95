#include "cli/lists.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>

using namespace carom::cli;

TEST_CASE("numbers may be decimals and fractions", "[lists]")
{
    CHECK(parse_number("0.001") == 0.001);
    CHECK(parse_number("1e-3") == 1e-3);
    CHECK(parse_number("1/240") == 1.0 / 240);
    CHECK(parse_number("-2/4") == -0.5);
    CHECK(parse_number("+3") == 3);
    CHECK(parse_number(" 0.5 ") == 0.5);
}

TEST_CASE("what is no finite number is refused", "[lists]")
{
    for (const char* text : {"", "x", "1/0", "1/", "/2", "1/2/3", "0.1s", "nan", "inf", "1e999", "0x10", "1,5"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_number(text), std::invalid_argument);
    }
}

TEST_CASE("whole numbers may be written with an exponent", "[lists]")
{
    CHECK(parse_integer("1e6", 1, 10000000) == 1000000);
    CHECK_THROWS_AS(parse_integer("1.5", 1, 10), std::invalid_argument);
    CHECK_THROWS_AS(parse_integer("0", 1, 10), std::invalid_argument);
    CHECK_THROWS_AS(parse_integer("11", 1, 10), std::invalid_argument);
}

TEST_CASE("lists are items, ranges, and both", "[lists]")
{
    CHECK(parse_list("1/60,1/240, 0.001") == std::vector<double>{1.0 / 60, 1.0 / 240, 0.001});
    CHECK(parse_list("1:3:lin5") == std::vector<double>{1, 1.5, 2, 2.5, 3});
    CHECK(parse_list("5,0:1:lin2,7") == std::vector<double>{5, 0, 1, 7});
    const std::vector<double> steps = parse_list("1e-4:1/10:log4");
    REQUIRE(steps.size() == 4);
    CHECK(steps.front() == 1e-4);
    CHECK(steps[1] == Approx(1e-3));
    CHECK(steps[2] == Approx(1e-2));
    CHECK(steps.back() == 0.1);
    CHECK(parse_list("3:1:lin3") == std::vector<double>{3, 2, 1});
}

TEST_CASE("broken lists are refused", "[lists]")
{
    for (const char* text : {"", ",", "1,,2", "1,", "1:2", "1:2:3", "1:2:lin", "1:2:lin1", "1:2:lin2.5", "1:2:exp3",
                             "0:1:log3", "-1:1:log3", "1:2:lin3:4", "a:2:lin3", "1:2:lin1e9"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_list(text), std::invalid_argument);
    }
}
