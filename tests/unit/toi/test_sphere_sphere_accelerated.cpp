#include "toi/sphere_sphere_accelerated.hpp"

#include "adversary/quartic_oracle.hpp"
#include "support/random.hpp"
#include "toi/accelerated_enclosure.hpp"
#include "toi/scaling.hpp"
#include "toi/sphere_sphere.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Float200;
using carom::test::Random;

namespace {

struct Tally {
    int queries = 0, hits = 0, wrong = 0, open = 0, certified_wrong = 0;
    double worst = 0;  ///< [ulp]
};

/// The exact solver finds what the oracle finds, open or not, in an interval of neighbouring doubles.
bool is_certified(const AcceleratedMotion& m, const test::AcceleratedTruth& truth)
{
    if (m.a.isZero(0) || truth.no_digits) return true;
    const Enclosure<double> answer =
        enclose_accelerated({exactly(m.r), exactly(m.v), exactly(m.a), DoubleDouble(m.contact_distance)});
    const Decision meant = truth.kind == RootKind::impact    ? Decision::impact
                           : truth.kind == RootKind::pressed ? Decision::pressed
                                                             : Decision::none;
    const bool contains = Float200(answer.t_lo) <= truth.t && truth.t <= Float200(answer.t_hi);
    const bool narrow = answer.t_hi <= std::nextafter(answer.t_lo, 1e308);
    const bool good = answer.decided == meant && (meant != Decision::impact || (contains && narrow));
    if (!good)
        UNSCOPED_INFO("certified " << int(answer.decided) << ": " << answer.t_lo << " .. " << answer.t_hi << " for "
                                   << int(meant) << " at " << truth.t.str(25) << ": r " << m.r.transpose() << ", v "
                                   << m.v.transpose() << ", a " << m.a.transpose() << ", S " << m.contact_distance);
    return good;
}

template <class Generate>
Tally run(std::uint64_t seed, int count, Generate&& generate)
{
    Random random(seed);
    Tally tally;
    for (int i = 0; i < count; ++i) {
        const AcceleratedMotion m = generate(random);
        const test::AcceleratedTruth truth = test::exact_accelerated(m);
        tally.certified_wrong += !is_certified(m, truth);
        const Root root = sphere_sphere_accelerated_root(m);
        ++tally.queries;
        if (truth.open) {
            ++tally.open;
            continue;
        }
        if (root.kind != truth.kind) {
            if (++tally.wrong <= 3)
                UNSCOPED_INFO("r " << m.r.transpose() << ", v " << m.v.transpose() << ", a " << m.a.transpose()
                                   << ", S " << m.contact_distance << ": " << int(root.kind) << " at " << root.t
                                   << ", exact " << int(truth.kind) << " at " << truth.t.convert_to<double>());
            continue;
        }
        if (truth.kind != RootKind::impact) continue;
        ++tally.hits;
        const double error = test::ulps(root.t, truth.t);
        if (error > 8 && error > tally.worst)
            UNSCOPED_INFO(error << " ulp: r " << m.r.transpose() << ", v " << m.v.transpose() << ", a "
                                << m.a.transpose() << ", S " << m.contact_distance);
        tally.worst = std::max(tally.worst, error);
    }
    return tally;
}

void require_exact(const Tally& tally, double worst_ulps)
{
    INFO("hits " << tally.hits << " of " << tally.queries << ", open " << tally.open << ", worst " << tally.worst
                 << " ulp");
    CHECK(tally.wrong == 0);
    CHECK(tally.certified_wrong == 0);
    CHECK(tally.worst <= worst_ulps);
    CHECK(tally.open <= tally.queries / 50);
    CHECK(tally.hits > 0);
}

/// At contact after `time` with relative velocity w, run back under a.
AcceleratedMotion backwards(const Vec3& contact, const Vec3& w, const Vec3& a, double time, double s)
{
    return {contact - time * w + (0.5 * time * time) * a, w - time * a, a, s};
}

}  // namespace

TEST_CASE("impacts under unequal accelerations, generated backwards, are found to 4 ulp")
{
    const Tally tally = run(1, 2000, [](Random& x) {
        const double s = x.uniform(0.1, 2);
        const Vec3 n = x.direction();
        const Vec3 w = -x.uniform(0.1, 5) * n + x.uniform(-5, 5) * x.across(n);
        return backwards(s * n, w, Vec3(0, 0, 9.81), x.uniform(0.01, 2), s);
    });
    require_exact(tally, 4);
    CHECK(tally.hits == tally.queries);
}

TEST_CASE("random unequal accelerations agree with the expanded quartic")
{
    require_exact(run(2, 2000,
                      [](Random& x) {
                          const Vec3 r = x.in_cube(4), v = x.in_cube(5), a = x.in_cube(9);
                          return AcceleratedMotion{r, v, a, x.uniform(0.1, 2)};
                      }),
                  4);
}

TEST_CASE("under unequal accelerations far, fast, tiny and huge impacts are found")
{
    require_exact(run(3, 300,
                      [](Random& x) {
                          const Vec3 n = x.direction();
                          return backwards(n, -x.uniform(0.1, 5) * n + x.uniform(-2, 2) * x.across(n), x.in_cube(9),
                                           x.log_uniform(1e2, 1e3), 1);
                      }),
                  8);
    for (const double length : {1e-160, 1e150})
        require_exact(run(4, 300,
                          [length](Random& x) {
                              const Vec3 r = x.in_cube(4), v = x.in_cube(5), a = x.in_cube(9);
                              return AcceleratedMotion{length * r, length * v, length * a, length};
                          }),
                      4);
    require_exact(run(5, 300,
                      [](Random& x) {
                          const Vec3 r = x.in_cube(4), v = x.in_cube(5), a = x.in_cube(1);
                          return AcceleratedMotion{r, v, x.log_uniform(1e-12, 1e-3) * a, 1};
                      }),
                  8);
}

TEST_CASE("pairs that overlap by rounding, separate and come back are found again, and those that only leave are not")
{
    const Tally back = run(6, 1500, [](Random& x) {
        const Vec3 n = x.direction();
        const Vec3 v = x.log_uniform(1e-3, 3) * n + x.uniform(-0.5, 0.5) * x.across(n);
        const double gap = x.integer(-1, 1) * x.log_uniform(1e-17, 1e-15);
        return AcceleratedMotion{(1 + gap) * n, v, -9.81 * n, 1};
    });
    require_exact(back, 16);
    CHECK(back.hits == back.queries);
    Random random(7);
    for (int i = 0; i < 300; ++i) {
        const Vec3 n = random.direction();
        const AcceleratedMotion leaving{(1 - 1e-16) * n, random.uniform(0.01, 3) * n, 9.81 * n, 1};
        CHECK(sphere_sphere_accelerated_root(leaving).kind == RootKind::none);
    }
}

TEST_CASE("grazing under unequal accelerations is decided within 1e-9 and 1e-13")
{
    for (const double delta : {1e-6, 1e-9, 1e-13}) {
        INFO("delta " << delta);
        const Tally tally = run(8, 400, [delta](Random& x) {
            const Vec3 n = x.direction(), w = x.uniform(0.1, 5) * x.across(n);
            return backwards((1 + x.uniform(-delta, delta)) * n, w, x.uniform(-1, 9) * x.direction(), x.uniform(0.1, 2),
                             1);
        });
        require_exact(tally, 16);
        CHECK(tally.hits < tally.queries);
    }
}

TEST_CASE("unequal accelerations at a touch: closing is now, pressed is a contact, a turn inside is when it closes")
{
    const Vec3 n(0, 0, 1);
    CHECK(sphere_sphere_accelerated_root({n, -n, Vec3(1, 0, 0), 1}).t == 0);
    CHECK(sphere_sphere_accelerated_root({n, -n, Vec3(1, 0, 0), 1}).kind == RootKind::impact);
    CHECK(sphere_sphere_accelerated_root({n, Vec3::Zero(), -n, 1}).kind == RootKind::pressed);
    CHECK(sphere_sphere_accelerated_root({n, Vec3::Zero(), n, 1}).kind == RootKind::none);
    // Rises inside from 0.5 at speed 0.5 under 1 down: turns at t = 0.5 at depth 0.375.
    const Root turn = sphere_sphere_accelerated_root({0.5 * n, 0.5 * n, -n, 1});
    CHECK(turn.kind == RootKind::impact);
    CHECK(turn.t == Approx(0.5).epsilon(1e-15));
}

TEST_CASE("equal accelerations give the bits of the quadratic, and swapping changes none")
{
    Random random(9);
    for (int i = 0; i < 500; ++i) {
        const Vec3 r = random.in_cube(4), v = random.in_cube(5), a = random.in_cube(9);
        const Root uniform = sphere_sphere_accelerated_root({r, v, Vec3::Zero(), 1});
        CHECK(uniform.kind == sphere_sphere_root(r, v, 1).kind);
        CHECK(uniform.t == sphere_sphere_root(r, v, 1).t);
        const Root root = sphere_sphere_accelerated_root({r, v, a, 1}),
                   swapped = sphere_sphere_accelerated_root({-r, -v, -a, 1});
        CHECK(root.kind == swapped.kind);
        CHECK(root.t == swapped.t);
    }
}

TEST_CASE("scaling by powers of two changes no bit under unequal accelerations")
{
    Random random(10);
    for (int i = 0; i < 500; ++i) {
        const Vec3 r = random.in_cube(4), v = random.in_cube(5), a = random.in_cube(9);
        const Root root = sphere_sphere_accelerated_root({r, v, a, 1});
        const int length = random.integer(-200, 200), time = random.integer(-100, 100);
        const Root scaled =
            sphere_sphere_accelerated_root({std::ldexp(1, length) * r, std::ldexp(1, length - time) * v,
                                            std::ldexp(1, length - 2 * time) * a, std::ldexp(1, length)});
        CHECK(scaled.kind == root.kind);
        CHECK(scaled.t == std::ldexp(root.t, time));
    }
}

TEST_CASE("turns beyond the range of doubles hide no impact", "[toi]")
{
    const auto solve = [](const Vec3& r, const Vec3& v, const Vec3& a, double s) {
        const Enclosure<double> out = enclose_accelerated({exactly(r), exactly(v), exactly(a), DoubleDouble(s)});
        CHECK((out.decided != Decision::impact || out.t_hi <= std::nextafter(out.t_lo, 1e308)));
        return out;
    };
    SECTION("the way back begins at t = 1e410")
    {
        const auto out = solve({10, 0, 0}, {-1e210, 0, 0}, {1e-200, 0, 0}, 1);
        CHECK(out.t_lo <= 9e-210);
        CHECK(out.t_hi >= 9e-210);
    }
    SECTION("a time that is subnormal in the unit in which bodies fall a length")
    {
        const auto out = solve({1 + 0x1p-50, 0, 0}, {-0x1p600, 0, 0}, {0x1p-780, 0, 0}, 1);
        CHECK(out.t_lo >= 0x1p-650 * (1 - 0x1p-51));
        CHECK(out.t_hi <= 0x1p-650 * (1 + 0x1p-51));
    }
    SECTION("there and back again, just within the range")
    {
        // x = 3 + v t - a t^2/2 is back at 1 at t = 2 v/a + 2/v = 2e300.
        const auto out = solve({3, 0, 0}, {1e150, 0, 0}, {-1e-150, 0, 0}, 1);
        CHECK(out.decided == Decision::impact);
        CHECK(std::abs(out.t_lo / 2e300 - 1) < 1e-15);
    }
    SECTION("back too late")
    {
        CHECK(solve({3, 0, 0}, {1e200, 0, 0}, {-1e-150, 0, 0}, 1).decided == Decision::none);
        CHECK(solve({3, 0, 0}, {1e-5, 0, 0}, {-0x1p-1074, 0, 0}, 1).decided == Decision::none);
    }
    SECTION("a fall that lasts beyond the range ends in the contact distance before")
    {
        // The centres would meet at 1e308, beyond the last time that is looked at.
        const auto out = solve({2.5e292, 0, 0}, {0, 0, 0}, {-0x1p-1074, 0, 0}, 2.1e292);
        CHECK(out.decided == Decision::impact);
        const double fallen = 2.5e292 - 2.1e292;
        CHECK(std::abs(out.t_lo / (std::sqrt(2 * fallen) * 0x1p537) - 1) < 1e-9);
    }
}
