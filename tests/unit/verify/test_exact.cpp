#include "support/multiprecision.hpp"
#include "support/random.hpp"
#include "verify/exact.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using verification::Exact;

TEST_CASE("the sign of a sum of products is that of many digits, however much cancels", "[verify]")
{
    Random random(1);
    int zeros = 0;
    for (int i = 0; i < 2000; ++i) {
        const double a = random.uniform(-1, 1), b = random.uniform(-1, 1) * 1e-20, c = random.uniform(-1, 1) * 1e12;
        const Exact x(a, b), y(c);
        const Float700 fx = Float700(a) + Float700(b), fy(c);
        // (x + y)^2 - x^2 - 2 x y - y^2 = 0, and a hair beside it.
        const double hair = i % 2 == 0 ? 0.0 : random.uniform(-1, 1) * 1e-60;
        const Exact difference = (x + y) * (x + y) - x * x - Exact(2.0) * x * y - y * y + Exact(hair) * (x - y * y);
        const Float700 expected = Float700(hair) * (fx - fy * fy);
        CHECK(difference.sound());
        CHECK(difference.sign() == (expected > 0) - (expected < 0));
        zeros += difference.sign() == 0;
    }
    CHECK(zeros >= 1000);
}

TEST_CASE("a product beyond the range of exact products says so", "[verify]")
{
    CHECK_FALSE((Exact(1e-200) * Exact(1e-200)).sound());
    CHECK_FALSE((Exact(1e200) * Exact(1e200)).sound());
    CHECK((Exact(1e-100) * Exact(1e-100)).sound());
}
