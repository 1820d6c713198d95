#include "math/dyadic.hpp"

#include "support/multiprecision.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <limits>

using namespace carom;
using carom::test::Float;
using carom::test::Random;
using Many = Float<1500>;  // holds products of four doubles between 1e-300 and 1e300 exactly

namespace {

double any(Random& random, double exponents)
{
    return random.sign() * random.uniform(1, 2) *
           std::ldexp(1, static_cast<int>(random.uniform(-exponents, exponents)));
}

int sign_of(const Many& x)
{
    return x < 0 ? -1 : x > 0 ? 1 : 0;
}

}  // namespace

TEST_CASE("polynomials of doubles have their exact sign and value, over the whole range of exponents", "[dyadic]")
{
    Random random(1);
    for (const double exponents : {2.0, 60.0, 900.0}) {
        for (int i = 0; i < 1000; ++i) {
            const double a = any(random, exponents), b = any(random, exponents), c = any(random, exponents),
                         d = any(random, exponents);
            const Dyadic exact = Dyadic(a) * Dyadic(b) * (Dyadic(c) - Dyadic(d)) + Dyadic(a) * Dyadic(a) - Dyadic(b);
            const Many truth = Many(a) * b * (Many(c) - d) + Many(a) * a - b;
            REQUIRE(exact.sign() == sign_of(truth));
            int exponent = 0;
            const Many scaled = frexp(truth, &exponent);
            const DoubleDouble rounded = exact.rounded(-exponent);
            REQUIRE(abs(Many(rounded.high) + rounded.low - scaled) <= 0x1p-104 * abs(scaled));
        }
    }
}

TEST_CASE("what cancels to zero is zero, and the last bit is seen when it does not", "[dyadic]")
{
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const double a = any(random, 400), b = any(random, 400), c = any(random, 400);
        const Dyadic x(a), y(b), z(c);
        CHECK(((x + y) * (x - y) - (x * x - y * y)).sign() == 0);
        CHECK(((x + y) + z - (x + (y + z))).sign() == 0);
        const Dyadic tiny(std::numeric_limits<double>::denorm_min());
        CHECK(((x + y) * (x - y) - (x * x - y * y) + tiny * tiny).sign() == 1);
        CHECK(((x + y) * (x - y) - (x * x - y * y) - tiny * tiny * tiny).sign() == -1);
    }
    CHECK(Dyadic().sign() == 0);
    CHECK(Dyadic(-0.0).sign() == 0);
    CHECK((Dyadic(0.0) * Dyadic(5.0)).sign() == 0);
}

TEST_CASE("carries and borrows run through all digits", "[dyadic]")
{
    const Dyadic one(1.0), ulp(std::ldexp(1, -1000));
    const Dyadic below = one - ulp;
    CHECK((below + ulp - one).sign() == 0);
    CHECK((below - one).sign() == -1);
    CHECK((below * below - one + ulp + ulp - ulp * ulp).sign() == 0);
}

TEST_CASE("integers, subnormals and double-doubles are taken as they are", "[dyadic]")
{
    const std::int64_t most = std::numeric_limits<std::int64_t>::max(),
                       least = std::numeric_limits<std::int64_t>::min();
    CHECK((Dyadic(most) - Dyadic(0x1p63) + Dyadic(1.0)).sign() == 0);
    CHECK((Dyadic(least) + Dyadic(0x1p63)).sign() == 0);
    CHECK((Dyadic(std::int64_t{-3}) + Dyadic(3.0)).sign() == 0);
    const double tiny = std::numeric_limits<double>::denorm_min();
    CHECK((Dyadic(tiny) * Dyadic(0x1p1000) - Dyadic(0x1p-74)).sign() == 0);
    const DoubleDouble third{1.0 / 3, 0x1p-56};
    CHECK((Dyadic(third) - Dyadic(1.0 / 3) - Dyadic(0x1p-56)).sign() == 0);
    CHECK(Dyadic(third).rounded().high == third.high);
    CHECK(Dyadic(third).rounded().low == third.low);
    CHECK(Dyadic(0x1p1000).rounded(100).high == std::numeric_limits<double>::infinity());
    CHECK(Dyadic(-0x1p-1000).rounded(-100).high == 0);
}
