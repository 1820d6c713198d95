#include "peers/program.hpp"
#include "script.hpp"

#include <catch2/catch.hpp>

#include <signal.h>

#include <chrono>

using namespace carom::peers;
using carom::test::Script;

namespace {

constexpr double long_enough = 30;  // s

/// Whether a process is there. A script writes its own number into a file before it does anything else.
bool is_there(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    pid_t id = 0;
    stream >> id;
    REQUIRE(id > 0);
    return ::kill(id, 0) == 0;
}

/// Waits until the file has a line.
void wait_for(const std::filesystem::path& file)
{
    for (int k = 0; k < 1000 && (!std::filesystem::exists(file) || std::filesystem::file_size(file) == 0); ++k)
        ::usleep(10'000);
}

}  // namespace

TEST_CASE("a program answers one request after the other, and is the same process all the time")
{
    const Script script("while read -r line; do echo \"$line, said $$\"; echo '# end'; done\n");
    Program program(script.file(), {});
    const Reply first = program.ask("one\n", {}, long_enough), second = program.ask("two\n", {}, long_enough);
    REQUIRE(first.talk == Talk::answered);
    REQUIRE(second.talk == Talk::answered);
    CHECK(first.text.substr(0, 9) == "one, said");
    CHECK(first.text.substr(3) == second.text.substr(3));
}

TEST_CASE("a program gets its arguments, and an answer longer than a pipe holds comes whole")
{
    const Script script("read -r line; seq \"$1\"; echo '# end'\n");
    Program program(script.file(), {"200000"});
    const Reply reply = program.ask("count\n", {}, long_enough);
    REQUIRE(reply.talk == Talk::answered);
    CHECK(reply.text.size() == 1'288'895);  // nine of 2 bytes, 90 of 3, ..., 100,001 of 7
}

TEST_CASE("a request longer than a pipe holds is sent whole")
{
    const Script script("read -r line; echo ${#line}; echo '# end'\n");
    Program program(script.file(), {});
    CHECK(program.ask(std::string(1'000'000, 'x') + "\n", {}, long_enough).text == "1000000\n");
}

TEST_CASE("a program that does not answer in time is killed, and so is one whose user does not want to wait")
{
    const Script script("echo $$ > \"$1\"; exec sleep 1000\n");
    const std::filesystem::path id = script.folder() / "id";
    Program program(script.file(), {id.string()});
    SECTION("too long")
    {
        const Reply reply = program.ask(
            "x\n",
            [&] {
                wait_for(id);
                return true;
            },
            0.2);
        CHECK(reply.talk == Talk::too_long);
    }
    SECTION("interrupted")
    {
        const Reply reply = program.ask(
            "x\n",
            [&] {
                wait_for(id);
                return false;
            },
            long_enough);
        CHECK(reply.talk == Talk::interrupted);
    }
    CHECK_FALSE(is_there(id));
    CHECK_FALSE(program.is_running());
}

TEST_CASE("a program is killed with who asked it")
{
    const Script script("echo $$ > \"$1\"; read -r line; echo '# end'; exec sleep 1000\n");
    const std::filesystem::path id = script.folder() / "id";
    {
        Program program(script.file(), {id.string()});
        REQUIRE(program.ask("x\n", {}, long_enough).talk == Talk::answered);
        CHECK(is_there(id));
    }
    CHECK_FALSE(is_there(id));
}

TEST_CASE("a program that ends without an answer, or is none, is broken and not waited for")
{
    const Script script("read -r line; echo half\n");
    Program program(script.file(), {});
    CHECK(program.ask("x\n", {}, long_enough).talk == Talk::broken);
    CHECK(program.ask("x\n", {}, long_enough).talk == Talk::broken);  // it is started anew
    Program none(script.folder() / "none", {});
    CHECK(none.ask("x\n", {}, long_enough).talk == Talk::broken);
}
