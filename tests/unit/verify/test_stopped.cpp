#include "support/recorded.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace carom;
using namespace carom::test;

namespace {

/// Examined until `amount` of the stage.
Certificate examined_until(MemorySource source, const std::string& stage, double amount, bool all_pairs)
{
    VerifyOptions options;
    options.all_pairs = all_pairs;
    options.on_progress = [&](const Progress& now) { return now.stage != stage || now.amount < amount; };
    return verify(source, options);
}

}  // namespace

TEST_CASE("an examination that is stopped finds nothing wrong in a right run, and says up to where", "[verify]")
{
    const Scene scene = gas(5, 60, 3, {0, 0, -1}, 0.9);
    const MemorySource source = recorded(scene);
    const double end = source.description.end->time;
    for (const bool all_pairs : {false, true})
        for (const double part : {0.0, 0.3, 0.9}) {
            CAPTURE(all_pairs, part);
            const Certificate c = examined_until(source, "flights", part * end, all_pairs);
            INFO(first_violation(c));
            CHECK(c.stopped);
            CHECK(c.holds());
            CHECK_FALSE(c.complete);
            CHECK(c.until <= end);
            CHECK(c.events < static_cast<std::int64_t>(source.events.size()));
        }
    const Certificate late = examined_until(source, "flights", 0.9 * end, false);
    CHECK(late.until > 0.5 * end);
    CHECK(late.smallest_gap < scene.spheres[0].radius);
}

TEST_CASE("an examination can be stopped before the run begins", "[verify]")
{
    const MemorySource source = recorded(gas(5, 60, 3));
    for (const char* stage : {"first flights", "initial overlaps"}) {
        const Certificate c = examined_until(source, stage, 0, false);
        CHECK(c.stopped);
        CHECK(c.until == 0);
        CHECK(c.holds());
    }
}

TEST_CASE("what was wrong before an examination is stopped stays a violation", "[verify]")
{
    MemorySource source = recorded(gas(5, 60, 3));
    const double end = source.description.end->time;
    // An early impact gets an impulse that no law gives.
    REQUIRE(source.events.size() > 100);
    source.events[10].impulse *= 2;
    CHECK_FALSE(examined_until(source, "flights", 0.9 * end, false).holds());
}
