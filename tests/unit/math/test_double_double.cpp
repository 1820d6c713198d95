#include "math/double_double.hpp"

#include "support/multiprecision.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;
using Real = carom::test::Float200;

namespace {

Real exact(DoubleDouble a)
{
    return Real(a.high) + Real(a.low);
}

/// A normalised double-double of some exponent; now and then its low part is 0 or tiny.
DoubleDouble any(Random& random)
{
    const double high = std::ldexp(random.sign() * random.uniform(1, 2), random.integer(-60, 60));
    const double part =
        random.integer(0, 5) == 0 ? 0 : std::ldexp(random.uniform(-0.5, 0.5), -53 - random.integer(0, 40));
    return two_sum(high, high * part);
}

/// |computed - wanted| / |wanted| in units of u^2.
double error(DoubleDouble computed, const Real& wanted)
{
    if (wanted == 0) return exact(computed) == 0 ? 0 : 1e300;
    return Real(abs(exact(computed) - wanted) / abs(wanted) * pow(Real(2), 106)).convert_to<double>();
}

bool is_normalised(DoubleDouble a)
{
    return a.high + a.low == a.high;
}

}  // namespace

TEST_CASE("double-double arithmetic keeps the bounds of Joldes, Muller and Popescu")
{
    Random random(1);
    double sum = 0, difference = 0, product = 0, quotient = 0, root = 0;
    for (int i = 0; i < 20000; ++i) {
        const DoubleDouble a = any(random), b = any(random);
        const Real x = exact(a), y = exact(b);
        sum = std::max(sum, error(a + b, x + y));
        difference = std::max(difference, error(a - b, x - y));
        product = std::max(product, error(a * b, x * y));
        quotient = std::max(quotient, error(a / b, x / y));
        root = std::max(root, error(sqrt(abs(a)), sqrt(abs(x))));
        CHECK(is_normalised(a + b));
        CHECK(is_normalised(a * b));
        CHECK(is_normalised(a / b));
        CHECK(is_normalised(sqrt(abs(a))));
    }
    CHECK(sum <= 3.0001);
    CHECK(difference <= 3.0001);
    CHECK(product <= 5);
    CHECK(quotient <= 10);
    CHECK(root <= 4);
    CHECK(product > 0.1);  // the measure measures
}

TEST_CASE("where two double-doubles cancel the difference still has its bound")
{
    Random random(2);
    for (int i = 0; i < 20000; ++i) {
        const DoubleDouble a = any(random);
        const double factor = std::ldexp(random.uniform(-1, 1), -random.integer(20, 105));
        const DoubleDouble b = a + a * DoubleDouble(factor);
        CHECK(error(a - b, exact(a) - exact(b)) <= 3.0001);
        CHECK((a < b) == (exact(a) < exact(b)));
        CHECK((a > b) == (exact(a) > exact(b)));
        CHECK((a <= b) == (exact(a) <= exact(b)));
        CHECK((a >= b) == (exact(a) >= exact(b)));
    }
    const DoubleDouble a = any(random);
    CHECK(exact(a - a) == 0);
    CHECK_FALSE(a < a);
    CHECK(a <= a);
}

TEST_CASE("square root of nothing and less is 0, squares come back")
{
    CHECK(exact(sqrt(DoubleDouble(0))) == 0);
    CHECK(exact(sqrt(DoubleDouble(-4))) == 0);
    Random random(3);
    for (int i = 0; i < 2000; ++i) {
        const double x = random.log_uniform(1e-10, 1e10);
        CHECK(error(sqrt(DoubleDouble(x) * DoubleDouble(x)), Real(x)) <= 4);
    }
}

TEST_CASE("dot and cross product of vectors of doubles are right to 1e-30 of their terms")
{
    Random random(4);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 a = random.in_cube(1),
                   b = i % 2 == 0 ? Vec3(a * (1 + 1e-15) + random.in_cube(1e-15)) : random.in_cube(1);
        const DoubleDouble3 x{a.x(), a.y(), a.z()}, y{b.x(), b.y(), b.z()};
        const auto u = test::lift<Real>(a), v = test::lift<Real>(b);
        CHECK(abs(exact(dot(x, y)) - test::dot(u, v)) <= 1e-30);
        const DoubleDouble3 c = cross(x, y);
        CHECK(abs(exact(c.x) - (u[1] * v[2] - u[2] * v[1])) <= 1e-30);
        CHECK(abs(exact(c.y) - (u[2] * v[0] - u[0] * v[2])) <= 1e-30);
        CHECK(abs(exact(c.z) - (u[0] * v[1] - u[1] * v[0])) <= 1e-30);
    }
}
