/// The law of linear drag against its formulas in 100 digits.
#include "flight/damping.hpp"

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

template <class Number>
double worst_of(const Damping<Number>& d, double k, const Real& t)
{
    const Real decay = exp(-k * t), way = (1 - decay) / k, fall = (t - way) / k;
    return std::max({relative_error(d.decay, decay), relative_error(d.way, way), relative_error(d.fall, fall)});
}

}  // namespace

TEST_CASE("place and velocity under drag keep their digits from k t of 1e-30 to 600, small times included")
{
    Random random(1);
    double worst = 0, worst_sharp = 0;
    for (int i = 0; i < 100000; ++i) {
        const double k = random.log_uniform(1e-12, 1e6);
        const double z = i % 2 == 0 ? random.log_uniform(1e-30, 600) : random.uniform(0, 4);
        const double t = z / k;
        worst = std::max(worst, worst_of(damping(k, t), k, t) / u);
        const DoubleDouble sharp = two_sum(t, t * random.uniform(-u, u));
        worst_sharp = std::max(worst_sharp, worst_of(damping(k, sharp), k, exact(sharp)) / (u * u * (64 + 16 * z)));
    }
    CAPTURE(worst, worst_sharp);
    CHECK(worst < 6);
    CHECK(worst_sharp < 1);
}

TEST_CASE("under drag a body comes to a stand after the way v/k, and falls at the speed g/k")
{
    const Damping<double> end = damping(2.0, 1e4);
    CHECK(end.decay == 0);
    CHECK(end.way == 0.5);
    CHECK(end.fall == (1e4 - 0.5) / 2);
}

TEST_CASE("the time of a way is the inverse of the way of a time")
{
    Random random(2);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double k = random.log_uniform(1e-12, 1e6);
        const double s = random.log_uniform(1e-30, 0.5) / k;
        worst = std::max(worst, relative_error(time_of_way(k, s), Real(-log1p(-Real(k) * s) / k)) / u);
    }
    CAPTURE(worst);
    CHECK(worst < 6);
    CHECK(time_of_way(1.0, 0.0) == 0);
}

TEST_CASE("the time at which a speed is used up is right for weak and strong accelerations")
{
    Random random(3);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const double k = random.log_uniform(1e-12, 1e6), w = random.log_uniform(1e-12, 1e6),
                     g = random.log_uniform(1e-12, 1e6);
        worst = std::max(worst, relative_error(turning_time(k, w, g), Real(log1p(Real(k) * w / g) / k)) / u);
    }
    CAPTURE(worst);
    CHECK(worst < 10);
    CHECK(turning_time(2, 1e10, 1e-300) == Approx((std::log(2.0) + 310 * std::log(10.0)) / 2));
}
