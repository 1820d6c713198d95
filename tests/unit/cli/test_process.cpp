// The tool as a process, in a child: what becomes of stdout, of memory that ends, of input that does not.
#include "cli/cli.hpp"
#include "cli/exit_codes.hpp"

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

using namespace carom::cli;
using Catch::Matchers::Contains;

namespace {

struct Ended {
    int code = -1;
    std::string err;
};

/// Runs the tool in a child whose stdout goes to a file, after `prepare` has been there.
Ended run_process(std::vector<std::string> args, const char* standard_output, const std::function<void()>& prepare = {})
{
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        ::dup2(::open(standard_output, O_WRONLY), STDOUT_FILENO);
        ::dup2(ends[1], STDERR_FILENO);
        ::close(ends[0]);
        if (prepare) prepare();
        args.insert(args.begin(), "carom");
        std::vector<char*> pointers;
        for (std::string& each : args) pointers.push_back(each.data());
        ::_exit(run_cli(static_cast<int>(pointers.size()), pointers.data()));
    }
    ::close(ends[1]);
    Ended ended;
    char chunk[4096];
    for (ssize_t n = 0; (n = ::read(ends[0], chunk, sizeof chunk)) > 0;)
        ended.err.append(chunk, static_cast<std::size_t>(n));
    ::close(ends[0]);
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
    return ended;
}

}  // namespace

TEST_CASE("a stdout that takes nothing is an error with its reason", "[process]")
{
    for (const auto& args : std::vector<std::vector<std::string>>{
             {"run", "bouncing_ball", "--json"}, {"scenes"}, {"run", "bouncing_ball"}, {"run", "-h"}}) {
        const Ended full = run_process(args, "/dev/full");
        CHECK(full.code == exit_failed);
        CHECK(full.err == "carom: stdout: cannot be written: No space left on device\n");
        const Ended fine = run_process(args, "/dev/null");
        CHECK(fine.code == exit_ok);
        CHECK(fine.err.empty());
    }
}

#if !defined(__SANITIZE_ADDRESS__)  // which reserves more than any limit
TEST_CASE("memory that does not suffice is an error that says what to do", "[process]")
{
    const auto limit = [] {
        const rlimit bytes{200'000'000, 200'000'000};
        ::setrlimit(RLIMIT_AS, &bytes);
    };
    const std::string many =
        R"(/fill=[{"pattern": "line", "count": 3000000, "radius": 1, "gap": 1, "origin": [0, 0, 9]}])";
    const Ended ended = run_process({"run", "bouncing_ball", "--set", many}, "/dev/null", limit);
    CHECK(ended.code == exit_failed);
    CHECK_THAT(ended.err, Contains("carom: out of memory (take fewer spheres") && !Contains("bad_alloc"));
}
#endif

TEST_CASE("scenes of endless bytes are refused, binary ones at once", "[process]")
{
    const auto limit = [] {
        const rlimit seconds{10, 10};  // of CPU: then the child is killed
        ::setrlimit(RLIMIT_CPU, &seconds);
    };
    const Ended zeros = run_process({"run", "/dev/zero"}, "/dev/null", limit);
    CHECK(zeros.code == exit_bad_input);
    CHECK_THAT(zeros.err, Contains("/dev/zero: is a binary file"));
}
