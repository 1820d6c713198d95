/// The closed form against a loop that bounces in 100 digits.
#include "motion/series.hpp"

#include "support/multiprecision.hpp"
#include "support/random.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using Real = carom::test::Float<100>;
using Real3 = carom::test::Real3<Real>;

namespace {

struct Bouncing {
    Real height = 0, normal_speed = 0;
    Real3 shift{}, velocity{};
};

constexpr int all_that_fit = 1000000;

/// Bounce by bounce until tau falls inside a flight, or until that many flights are over.
Bouncing bounce(const Series& s, const Real& tau, int flights = all_that_fit)
{
    const Real g = s.gravity, e = s.restitution, alpha = s.tangential;
    Real speed = s.normal_speed, rest = tau;
    Bouncing b;
    b.velocity = test::lift<Real>(s.velocity);
    const Real3 a = test::lift<Real>(s.acceleration);
    const auto fly = [&](const Real& t) {
        for (int k = 0; k < 3; ++k) {
            b.shift[k] += b.velocity[k] * t + a[k] * t * t / 2;
            b.velocity[k] += a[k] * t;
        }
    };
    for (int n = 0; n < flights; ++n) {
        const Real flight = 2 * speed / g;
        if (rest < flight) break;
        fly(flight);
        for (auto& v : b.velocity) v *= alpha;
        rest -= flight;
        speed *= e;
    }
    if (flights != all_that_fit) return b;
    fly(rest);
    b.height = speed * rest - g * rest * rest / 2;
    b.normal_speed = speed - g * rest;
    return b;
}

double difference(const Vec3& a, const Real3& b)
{
    double worst = 0;
    for (int k = 0; k < 3; ++k) worst = std::max(worst, Real(abs(Real(a[k]) - b[k])).convert_to<double>());
    return worst;
}

Series example(double e, double alpha, const Vec3& acceleration)
{
    return {.normal_speed = 1.3,
            .gravity = 9.81,
            .restitution = e,
            .tangential = alpha,
            .velocity = {0.7, -0.2, 0},
            .acceleration = acceleration};
}

const Vec3 slope(2.5, 1, 0);

}  // namespace

TEST_CASE("at any moment of a series the state is that of the bounces one by one")
{
    test::Random random(1);
    for (const double e : {0.01, 0.5, 0.8, 0.999})
        for (const double alpha : {1.0, 0.7, 0.0})
            for (const Vec3& acceleration : {Vec3(0, 0, 0), slope}) {
                const Series s = example(e, alpha, acceleration);
                INFO("e " << e << ", alpha " << alpha << ", slope " << acceleration.norm());
                for (int i = 0; i < 40; ++i) {
                    const double tau = s.duration() * random.uniform(0, e > 0.99 ? 0.9 : 0.999);
                    const SeriesState state = state_in(s, tau);
                    const Bouncing exact = bounce(s, tau);
                    const double length = s.height() + s.duration() * s.duration() * acceleration.norm() + s.duration();
                    CHECK(std::abs(Real(Real(state.height) - exact.height).convert_to<double>()) <= 1e-14 * length);
                    CHECK(std::abs(Real(Real(state.normal_speed) - exact.normal_speed).convert_to<double>()) <=
                          1e-14 * (s.normal_speed + s.gravity * s.duration()));
                    CHECK(difference(state.shift, exact.shift) <= 1e-14 * length);
                    CHECK(difference(state.velocity, exact.velocity) <=
                          1e-13 * (1 + s.duration() * acceleration.norm()));
                    CHECK(state.height >= 0);
                }
            }
}

TEST_CASE("right before and after a bounce the right flight is taken")
{
    for (const double e : {0.01, 0.5, 0.8, 0.999}) {
        const Series s = example(e, 0.7, slope);
        const double t1 = s.first_flight();
        double bounce_time = t1, e_power = e;
        for (int k = 1; k <= 8; ++k) {
            const double margin = 1e-13 * bounce_time;
            if (2 * margin > t1 * e_power) break;  // the flights have become shorter than the margin
            const SeriesState before = state_in(s, bounce_time - margin), later = state_in(s, bounce_time + margin);
            INFO("e " << e << ", bounce " << k);
            const double slack = 2 * s.gravity * margin;  // gained or lost within the margin
            CHECK(before.normal_speed == Approx(-s.normal_speed * e_power / e).epsilon(1e-9).margin(slack));
            CHECK(later.normal_speed == Approx(s.normal_speed * e_power).epsilon(1e-9).margin(slack));
            CHECK(before.height <= 10 * margin * s.normal_speed);
            CHECK(later.height <= 10 * margin * s.normal_speed);
            CHECK(later.velocity.norm() == Approx(0.7 * before.velocity.norm()).epsilon(1e-9));
            bounce_time += t1 * e_power;
            e_power *= e;
        }
    }
    const Series s = example(0.5, 1, Vec3::Zero());
    CHECK(state_in(s, 0).normal_speed == s.normal_speed);
    CHECK(state_in(s, 0).height == 0);
    CHECK(state_in(s, s.first_flight()).normal_speed == 0.5 * s.normal_speed);
}

TEST_CASE("a series ends when and where infinitely many bounces end")
{
    for (const double e : {0.01, 0.5, 0.8, 0.999})
        for (const double alpha : {1.0, 0.7, 0.0}) {
            const Series s = example(e, alpha, slope);
            INFO("e " << e << ", alpha " << alpha);
            CHECK(s.duration() == Approx(2 * 1.3 / (9.81 * (1 - e))).epsilon(1e-15));
            const SeriesState end = state_at_end(s);
            CHECK(end.height == 0);
            CHECK(end.normal_speed == 0);
            // Until e^n and alpha^n are below 1e-40: nothing is left of the rest.
            const double slower = alpha < 1 ? std::max(e, alpha) : e;
            const Bouncing exact = bounce(s, 1e9, static_cast<int>(95 / -std::log(slower)) + 2);
            CHECK(difference(end.shift, exact.shift) <= 1e-13 * (s.duration() + s.duration() * s.duration()));
            CHECK(difference(end.velocity, exact.velocity) <= 1e-13 * (1 + s.duration()));
        }
}

TEST_CASE("a drop's series from its first impact ends at sqrt(2h/g) (1+e)/(1-e)")
{
    const double g = 9.81, h = 1, e = 0.5, fall = std::sqrt(2 * h / g);
    const Series s{.normal_speed = e * g * fall, .gravity = g, .restitution = e};
    CHECK(fall + s.duration() == Approx(1.354570923).epsilon(1e-9));
    CHECK(fall + s.duration() == Approx(fall * (1 + e) / (1 - e)).epsilon(1e-15));
    CHECK(s.height() == Approx(e * e * h).epsilon(1e-15));
}
