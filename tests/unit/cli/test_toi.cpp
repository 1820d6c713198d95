#include "cli/toi_command.hpp"

#include "cli/arguments.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
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

TEST_CASE("a line without end is answered before it ends, and the next line after it", "[toi]")
{
    /// 'x' for ever as far as the service may look ahead, then a line.
    class Endless : public std::streambuf {
    public:
        std::size_t taken = 0;

    protected:
        int_type underflow() override
        {
            constexpr std::size_t far = 1 << 24;
            if (taken > far) return traits_type::eof();
            taken += chunk_.size();
            if (taken > far) chunk_.back() = '\n';
            setg(chunk_.data(), chunk_.data(), chunk_.data() + chunk_.size());
            return traits_type::to_int_type(chunk_.front());
        }

    private:
        std::string chunk_ = std::string(4096, 'x');
    };
    /// Remembers how much had been taken when the first answer was complete.
    class Answers : public std::stringbuf {
    public:
        explicit Answers(const Endless& asked) : asked_(asked) {}
        std::size_t first = 0;

    protected:
        int sync() override
        {
            if (first == 0) first = asked_.taken;
            return 0;
        }

    private:
        const Endless& asked_;
    };
    Endless source;
    Answers answers(source);
    std::istream in(&source);
    std::ostream out(&answers);
    serve_toi(in, out);
    CHECK(answers.str() == "{\"status\":\"error\",\"message\":\"longer than 65536 characters\"}\n");
    CHECK(answers.first > 0);
    CHECK(answers.first < (1 << 17));
    for (const std::size_t length : {65535u, 65536u, 65537u}) {
        CAPTURE(length);
        std::istringstream long_one(std::string(length, ' ') + "\n\n1");
        std::ostringstream three;
        serve_toi(long_one, three);
        const std::string text = three.str();
        CHECK(std::count(text.begin(), text.end(), '\n') == 3);
        CHECK((text.find("longer") != std::string::npos) == (length > 65536));
    }
    std::istringstream then(std::string(100'000, 'x') + "\nnonsense");
    std::ostringstream said;
    serve_toi(then, said);
    const std::string both = said.str();
    CHECK(std::count(both.begin(), both.end(), '\n') == 2);
    CHECK(both.find("no JSON") != std::string::npos);
}

TEST_CASE("the help of toi names every key of a query and of its answer", "[toi]")
{
    const std::string help = parse_arguments({"toi", "-h"}).out;
    for (const char* key : {"\"p\"", "\"v\"", "\"acc\"", "\"r\"", "\"n\"", "\"offset\"", "\"thickness\"", "until",
                            "status", "touching", "overlap", "lo", "hi", "level"}) {
        CAPTURE(key);
        CHECK(help.find(key) != std::string::npos);
    }
}

TEST_CASE("toi is a command with an example in its help", "[toi]")
{
    const ParseResult parsed = parse_arguments({"toi"});
    REQUIRE(parsed.arguments);
    CHECK(parsed.arguments->command == Command::toi);
    CHECK(parse_arguments({"toi", "-h"}).out.find("carom toi") != std::string::npos);
    CHECK_FALSE(parse_arguments({"toi", "more"}).arguments);
}
