#include "io/output_file.hpp"

#include <carom/error.hpp>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace carom;
using carom::io::DescriptorBuffer;
using carom::io::OutputFile;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

TEST_CASE("what is written arrives to the byte, in pieces smaller and larger than the buffer", "[output_file]")
{
    const fs::path path = fs::temp_directory_path() / ("carom-output-" + std::to_string(::getpid()));
    std::string expected;
    {
        OutputFile out(path);
        for (int i = 0; i < 20'000; ++i) {
            const std::string piece(static_cast<std::size_t>(i % 37), static_cast<char>('a' + i % 26));
            out.stream() << piece << '\n';
            expected += piece + '\n';
        }
        const std::string large(300'000, 'x');
        out.stream() << large;
        expected += large;
        out.close();
    }
    std::ifstream stream(path, std::ios::binary);
    CHECK(std::string(std::istreambuf_iterator<char>(stream), {}) == expected);
    fs::remove(path);
}

TEST_CASE("a full disk is named as the reason, at the latest when the file is closed", "[output_file]")
{
    OutputFile small("/dev/full");
    small.stream() << "a line\n";
    CHECK_NOTHROW(small.check());  // it waits in the buffer
    CHECK_THROWS_WITH(small.close(), Contains("/dev/full: cannot be written: No space left on device"));
    OutputFile large("/dev/full");
    for (int i = 0; i < 100'000; ++i) large.stream() << i << '\n';
    CHECK_THROWS_WITH(large.check(), Contains("No space left on device"));
    CHECK_THROWS_WITH(OutputFile("/nowhere/at/all"), Contains("/nowhere/at/all: cannot be written: No such file"));
}

TEST_CASE("a descriptor's buffer keeps its first failure", "[output_file]")
{
    const int full = ::open("/dev/full", O_WRONLY);
    REQUIRE(full >= 0);
    {
        DescriptorBuffer buffer(full);
        std::ostream stream(&buffer);
        CHECK(buffer.failure().empty());
        stream << "text" << std::flush;
        CHECK_FALSE(stream);
        CHECK(buffer.failure() == "No space left on device");
    }
    ::close(full);
    DescriptorBuffer closed(-1);
    CHECK(closed.pubsync() == 0);  // nothing to write
    closed.sputc('x');
    CHECK(closed.pubsync() == -1);
    CHECK(closed.failure() == "Bad file descriptor");
}
