#include "recording_file.hpp"

#include <catch2/catch.hpp>

#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <thread>

using namespace carom;
using namespace carom::test;

namespace {

/// Returns at the latest after half a minute.
void wait_for_size(const std::filesystem::path& file, std::uintmax_t size)
{
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    std::error_code none;
    while (std::chrono::steady_clock::now() < limit) {
        const std::uintmax_t now = std::filesystem::file_size(file, none);
        if (!none && now >= size) return;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
}

}  // namespace

TEST_CASE("a recording process that is killed leaves what verifies up to its last chunk", "[recording]")
{
    const RecordingFolder folder;
    Random random(4);
    int with_flights = 0, with_journal = 0;
    double longest = 0;
    for (int i = 0; i < 20; ++i) {
        const std::filesystem::path file = folder / ("run" + std::to_string(i) + ".carom");
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            record_to(file, gas(5, 100, 1e9, {0, 0, -1}));
            ::_exit(0);
        }
        // A random moment in the growth of the file, and a little later: how fast the machine is plays no part.
        wait_for_size(file, static_cast<std::uintmax_t>(random.uniform(0, 400e3)));
        std::this_thread::sleep_for(std::chrono::microseconds(static_cast<int>(random.uniform(0, 20000))));
        ::kill(child, SIGKILL);
        int status = 0;
        REQUIRE(::waitpid(child, &status, 0) == child);
        REQUIRE(WIFSIGNALED(status));
        std::error_code none;
        with_journal += std::filesystem::file_size(file.string() + "-journal", none) > 0 && !none;
        // Killed before there was anything: no file, or an empty one.
        if (!std::filesystem::exists(file) || std::filesystem::file_size(file) == 0) continue;
        try {
            RecordingReader reader(file);
            const Certificate c = verify(reader);
            INFO((c.violations.empty() ? std::string() : c.violations.front().what));
            CHECK(c.holds());
            CHECK_FALSE(c.complete);
            with_flights += c.flights > 100;
            longest = std::max(longest, c.until);
        } catch (const InputError& error) {
            // Only the moments before the tables were there.
            INFO(error.what());
            CHECK_THAT(error.what(),
                       Catch::Matchers::Contains("no carom recording") || Catch::Matchers::Contains("not the tables"));
        }
    }
    CHECK(with_flights >= 10);
    CHECK(longest > 1);
    WARN("killed 20 times: " << with_flights << " with chunks, " << with_journal << " in the middle of writing one");
}
