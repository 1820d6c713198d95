#include "math/error_free.hpp"

#include "support/multiprecision.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;
using Real = carom::test::Float<400>;

namespace {

double any(Random& random)
{
    return std::ldexp(random.uniform(-2, 2), random.integer(-100, 100));
}

}  // namespace

TEST_CASE("two_sum and two_product lose nothing, whatever the exponents")
{
    Random random(1);
    for (int i = 0; i < 20000; ++i) {
        const double a = any(random), b = i % 5 == 0 ? -a * (1 + random.uniform(-1, 1) * 1e-15) : any(random);
        const Sum s = two_sum(a, b), p = two_product(a, b);
        CHECK(s.high == a + b);
        CHECK(Real(s.high) + Real(s.low) == Real(a) + Real(b));
        CHECK(p.high == a * b);
        CHECK(Real(p.high) + Real(p.low) == Real(a) * Real(b));
        CHECK(std::abs(p.low) <= unit_roundoff * std::abs(p.high));
    }
}

TEST_CASE("fast_two_sum loses nothing if the first summand is the larger")
{
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        double a = any(random), b = any(random);
        if (std::abs(a) < std::abs(b)) std::swap(a, b);
        const Sum s = fast_two_sum(a, b);
        CHECK(Real(s.high) + Real(s.low) == Real(a) + Real(b));
    }
    CHECK(fast_two_sum(0, 3).high == 3);
    CHECK(fast_two_sum(0, 3).low == 0);
}

TEST_CASE("a difference of products keeps its digits where plain arithmetic loses them all")
{
    Random random(3);
    int plain_wrong = 0;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double a = random.uniform(1, 2), b = random.uniform(1, 2), c = random.uniform(1, 2);
        const double d = a * b / c * (1 + random.uniform(-1, 1) * (i % 2 == 0 ? 1e-15 : 1));
        const Real exact = Real(a) * Real(b) - Real(c) * Real(d);
        const double computed = difference_of_products(a, b, c, d);
        if (exact == 0) {
            CHECK(computed == 0);
            continue;
        }
        worst = std::max(worst, test::ulps(computed, exact));
        plain_wrong += test::ulps(a * b - c * d, exact) > 100;
    }
    CHECK(worst <= 1.5);
    CHECK(plain_wrong > 5000);
    CHECK(difference_of_products(3, 4, 6, 2) == 0);
}
