/// A small part of what carom_toi_adversary asks (tests/adversary), so that a change of the kernel is judged at once.
#include "adversary/tally.hpp"

#include <catch2/catch.hpp>

using namespace carom;

TEST_CASE("no impact is lost and none invented over all families, and every time is in its interval", "[adversary]")
{
    const auto tallies = test::challenge(60000, 7);
    INFO(test::table(tallies));
    long long impacts = 0, touching = 0, none = 0, exact = 0, undecided = 0;
    for (const test::Tally& tally : tallies) {
        INFO(tally.family);
        CHECK(tally.failures() == 0);
        CHECK(tally.worst_ulp <= 1);
        impacts += tally.impacts;
        touching += tally.touching;
        none += tally.none;
        exact += tally.level[2];
        undecided += tally.undecided;
    }
    // The families do ask what they are meant to ask.
    CHECK(impacts > 20000);
    CHECK(touching > 4000);
    CHECK(none > 15000);
    CHECK(exact > 1000);
    CHECK(undecided < 200);
}
