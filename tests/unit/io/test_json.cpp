#include "io/json.hpp"

#include <carom/error.hpp>
#include <catch2/catch.hpp>

using namespace carom;
using io::Json;
using io::parse_json;

namespace {

std::string error_of(std::string_view text)
{
    try {
        parse_json(text, "f.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return "(accepted)";
}

bool begins(const std::string& text, const std::string& start)
{
    return text.compare(0, start.size(), start) == 0;
}

}  // namespace

TEST_CASE("a JSON tree keeps the order of keys and the digits of numbers", "[io]")
{
    const Json json = parse_json(R"({"z": 1, "a": [1e-3, 18446744073709551615, "x", true, null]})", "f.json");
    REQUIRE(json.keys == std::vector<std::string>{"z", "a"});
    const Json& list = *json.find("a");
    REQUIRE(list.items.size() == 5);
    CHECK(list.items[0].text == "1e-3");
    CHECK(list.items[0].number == 0.001);
    CHECK(list.items[1].text == "18446744073709551615");
    CHECK(list.items[2].text == "x");
    CHECK(list.items[3].boolean);
    CHECK(list.items[4].kind == Json::Kind::null);
    CHECK(json.find("b") == nullptr);
}

TEST_CASE("a syntax error is reported at the line and column of the token that is wrong", "[io]")
{
    CHECK(begins(error_of("{\"a\": 1,\n  \"b\" 2}"), "f.json:2:7: syntax error"));
    CHECK(begins(error_of("[1, 2"), "f.json:1:6: the text ends too early"));
    CHECK(begins(error_of("{\"a\": \"abc"), "f.json:1:"));
    CHECK(begins(error_of("[1]\n\n x"), "f.json:3:2: "));
}

TEST_CASE("common slips come with their cure", "[io]")
{
    CHECK(begins(error_of("[1,\n NaN]"), "f.json:2:2: NaN and Infinity are not numbers"));
    CHECK(begins(error_of("[Infinity]"), "f.json:1:2: NaN and Infinity are not numbers"));
    CHECK(begins(error_of("[-Infinity]"), "f.json:1:2: NaN and Infinity are not numbers"));
    CHECK(begins(error_of("[1, ]"), "f.json:1:5: comma before the closing bracket"));
    CHECK(begins(error_of("{\"a\": 1, }"), "f.json:1:10: comma before the closing bracket"));
    CHECK(begins(error_of("[ // one\n1]"), "f.json:1:3: JSON has no comments"));
    CHECK(begins(error_of("{'a': 1}"), "f.json:1:2: JSON strings stand in double quotes"));
    CHECK(begins(error_of("[.5]"), "f.json:1:2: a number begins with a digit"));
}

TEST_CASE("a missing comma is reported where it belongs, not where the next value stands", "[io]")
{
    CHECK(error_of("{\"a\": 1\n  \"b\": 2}") == "f.json:1:8: a comma is missing at the end of line 1");
    CHECK(error_of("{\n\"a\": {\"x\": 1}  \n\n  \"b\": 2}") == "f.json:2:14: a comma is missing at the end of line 2");
    CHECK(error_of("[1 2]") == "f.json:1:3: a comma is missing here");
    CHECK(error_of("[[1]\n[2]]") == "f.json:1:5: a comma is missing at the end of line 1");
    CHECK(begins(error_of("[1 }"), "f.json:1:4: syntax error"));
    CHECK(begins(error_of("[1, ]"), "f.json:1:5: comma before"));
}

TEST_CASE("a number beyond the range of a double is refused with its place and pointer", "[io]")
{
    CHECK(begins(error_of("{\"g\": [0,\n 0, 1e999]}"), "f.json:2:5: /g/2: 1e999 is out of range"));
    CHECK(begins(error_of("{\"a\": -1e400}"), "f.json:1:7: /a: -1e400 is out of range"));
    CHECK(error_of("[1e308, 1e-400]") == "(accepted)");
}

TEST_CASE("duplicate keys are errors with their pointers, all of them", "[io]")
{
    const std::string error = error_of(R"({"a": {"x": 1, "x": 2}, "l": [{}, {"y/z": 1, "y/z": 1}], "a": 3})");
    CHECK(error ==
          "f.json: /a/x: duplicate key (remove one of the two)\n"
          "f.json: /l/1/y~1z: duplicate key (remove one of the two)\n"
          "f.json: /a: duplicate key (remove one of the two)");
    CHECK(error_of(R"([{"a": 1}, {"a": 1}])") == "(accepted)");
}

TEST_CASE("what is no text is called so", "[io]")
{
    CHECK(begins(error_of(""), "f.json: the file is empty"));
    CHECK(begins(error_of(" \n\t\r\n"), "f.json: the file is empty"));
    CHECK(begins(error_of("\x7f"
                          "ELF"),
                 "f.json: is a binary file"));
    CHECK(begins(error_of(std::string_view("{\0\"\0", 4)), "f.json: is a binary file"));
    CHECK(begins(error_of("\"\xff\""), "f.json:1:"));
    CHECK(error_of("\xef\xbb\xbf{}") == "(accepted)");
}

TEST_CASE("endless nesting is refused instead of exhausting the stack", "[io]")
{
    CHECK(begins(error_of(std::string(1'000'000, '[')), "f.json: nested deeper"));
    CHECK(error_of(std::string(60, '[') + std::string(60, ']')) == "(accepted)");
}
