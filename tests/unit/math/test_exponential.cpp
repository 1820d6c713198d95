/// Exponential and logarithm against MPFR's in 100 digits.
#include "math/exponential.hpp"

#include "support/random.hpp"
#include "support/relative_error.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::exact;
using carom::test::Random;
using carom::test::relative_error;
using Real = carom::test::Float100;

namespace {

constexpr double u = unit_roundoff;

DoubleDouble any_part(Random& random, double high)
{
    return two_sum(high, high * random.uniform(-u, u));
}

}  // namespace

TEST_CASE("the exponential is right to its bound over the whole range of doubles, in both arithmetics")
{
    Random random(1);
    double worst = 0, worst_sharp = 0;
    for (int i = 0; i < 100000; ++i) {
        const double size = random.coin() ? random.log_uniform(1e-20, 709) : random.uniform(0, 709);
        const double x = size > 708 ? -size : random.sign() * size;
        if (x < -700) continue;
        worst = std::max(worst, relative_error(exponential(x), exp(Real(x))) / u);
        const DoubleDouble y = any_part(random, x);
        // Low parts are subnormal below e^-670.
        if (x > -600)
            worst_sharp =
                std::max(worst_sharp, relative_error(exponential(y), exp(exact(y))) / (u * u * (16 + 8 * size)));
    }
    CAPTURE(worst, worst_sharp);
    CHECK(worst < 1.5);
    CHECK(worst_sharp < 1);
    CHECK(exponential(0.0) == 1);
    CHECK(exponential(-1e308 * 10) == 0);
    CHECK(exponential(-745.0) == std::exp(-745.0));
}

TEST_CASE("the tail of the exponential does not cancel near 0")
{
    Random random(2);
    double worst = 0, worst_sharp = 0;
    for (int i = 0; i < 50000; ++i) {
        const double x = random.sign() * random.log_uniform(1e-16, 1);
        const auto tail = [](const Real& y) { return Real((exp(y) - 1 - y) / y / y); };
        worst = std::max(worst, relative_error(exponential_tail(x), tail(x)) / u);
        const DoubleDouble y = any_part(random, x);
        worst_sharp = std::max(worst_sharp, relative_error(exponential_tail(y), tail(exact(y))) / (u * u));
    }
    CAPTURE(worst, worst_sharp);
    CHECK(worst < 3);
    CHECK(worst_sharp < 16);
    CHECK(exponential_tail(0.0) == 0.5);
}

TEST_CASE("logarithms are right to their bound from the smallest doubles to the largest, and close to 1")
{
    Random random(3);
    double worst = 0, worst_sharp = 0;
    for (int i = 0; i < 100000; ++i) {
        const double y =
            i % 2 == 0 ? random.log_uniform(1e-300, 1e300) : 1 + random.sign() * random.log_uniform(1e-15, 0.5);
        if (y == 1) continue;
        worst = std::max(worst, relative_error(logarithm(y), log(Real(y))) / u);
        const DoubleDouble x = any_part(random, y);
        if (y > 1e-270) worst_sharp = std::max(worst_sharp, relative_error(logarithm(x), log(exact(x))) / (u * u));
    }
    CAPTURE(worst, worst_sharp);
    CHECK(worst < 4);
    CHECK(worst_sharp < 32);
    CHECK(logarithm(1.0) == 0);
}

TEST_CASE("the logarithm of what is left of 1 does not cancel")
{
    Random random(4);
    double worst = 0, worst_sharp = 0;
    for (int i = 0; i < 100000; ++i) {
        const double z = i % 2 == 0 ? random.log_uniform(1e-300, 1) : random.uniform(0, 0.5);
        worst = std::max(worst, relative_error(minus_log_of_rest(z), Real(-log1p(Real(-z)))) / u);
        const double part = random.log_uniform(1e-200, 1);
        const DoubleDouble x = any_part(random, part);
        if (part < 0.99)
            worst_sharp =
                std::max(worst_sharp, relative_error(minus_log_of_rest(x), Real(-log1p(-exact(x)))) / (u * u));
    }
    CAPTURE(worst, worst_sharp);
    CHECK(worst < 4);
    CHECK(worst_sharp < 32);
}
