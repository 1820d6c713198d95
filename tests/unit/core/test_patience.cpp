#include "core/patience.hpp"

#include <catch2/catch.hpp>

using namespace carom;

TEST_CASE("patience without a question lasts for ever", "[patience]")
{
    Patience patience;
    for (int k = 0; k < 10'000; ++k) REQUIRE(patience.lasts_for(1));
    CHECK(patience.lasts());
    CHECK_FALSE(patience.ended());
}

TEST_CASE("patience that has ended does not come back, and nobody is asked again", "[patience]")
{
    int asked = 0;
    Patience patience([&](const Progress&) { return ++asked != 2; });
    CHECK(patience.lasts());
    CHECK_FALSE(patience.lasts());
    CHECK_FALSE(patience.lasts());
    CHECK_FALSE(patience.lasts_for(1'000'000));
    CHECK(patience.ended());
    CHECK(asked == 2);
}

TEST_CASE("small units of work ask seldom, large ones at once", "[patience]")
{
    int asked = 0;
    Patience patience([&](const Progress&) { return ++asked > 0; });
    for (int k = 0; k < 10'000; ++k) patience.lasts_for(1);
    CHECK(asked > 5);
    CHECK(asked < 100);
    const int before = asked;
    for (int k = 0; k < 10; ++k) patience.lasts_for(100'000);
    CHECK(asked == before + 10);
}

TEST_CASE("progress says the stage, what goes on in it, and how far it is", "[patience]")
{
    Progress seen;
    Patience patience([&](const Progress& now) {
        seen = now;
        return true;
    });
    patience.begin("fill", 8, "spheres");
    patience.name("fill of atoms");
    patience.lasts(2);
    CHECK(seen.stage == "fill");
    CHECK(seen.what == "fill of atoms");
    CHECK(seen.fraction == 0.25);
    CHECK(seen.amount == 2);
    CHECK(seen.unit == "spheres");
    patience.lasts(9);
    CHECK(seen.fraction == 1);
    patience.begin("nothing to do", 0);
    patience.lasts(0);
    CHECK(seen.fraction == 1);
    CHECK(seen.what == "nothing to do");
}
