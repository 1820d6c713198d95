#include "math/length.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;

TEST_CASE("the length of a moderate vector is the root of its square, bit for bit", "[length]")
{
    test::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 a = random.in_cube(10);
        CHECK(length(a) == std::sqrt(a.squaredNorm()));
    }
    CHECK(length(Vec3::Zero()) == 0);
}

TEST_CASE("lengths whose squares leave the range of doubles are right, too", "[length]")
{
    for (const int e : {-1060, -1000, -500, 500, 1000})
        CHECK(length(Vec3(std::ldexp(3.0, e), 0, std::ldexp(-4.0, e))) == std::ldexp(5.0, e));
}
