/// Impacts are generated backwards: choose the contact, run the motion back, ask for the time. The oracle judges the
/// inputs as rounded, not as meant.
#include "toi/sphere_sphere.hpp"

#include "support/random.hpp"
#include "unit/toi/oracle.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace carom;
using carom::test::Random;

namespace {

struct Query {
    Vec3 r, v;
    double s;
};

/// At closest approach the centres are `miss` * S apart; asked `distance` * S before.
Query passing(Random& random, double s, double miss, double distance, double speed)
{
    const Vec3 n = random.direction(), side = random.across(n);
    return {s * (miss * side - distance * n), speed * n, s};
}

/// Touching at direction n with the gap `gap` * S, and a normal speed of the given sign.
Query touching(Random& random, double gap, double normal_speed)
{
    const Vec3 n = random.direction(), side = random.across(n);
    const double s = random.uniform(0.5, 2);
    return {(s * (1 + gap)) * n, normal_speed * n + random.uniform(-1, 1) * side, s};
}

struct Tally {
    int queries = 0, hits = 0, missed = 0, spurious = 0, open = 0, textbook_missed = 0, textbook_spurious = 0,
        beyond_bound = 0;
    double worst = 0;  ///< [ulp]
};

/// The relative error that the rounding of level 0 may cause (first order; twice it is allowed).
double level_0_bound(const Query& q)
{
    const double u = 0x1p-53;
    const Vec3 k = q.r.cross(q.v);
    const double s2 = q.s * q.s, r2 = q.r.squaredNorm(), a = q.v.squaredNorm();
    const double b = q.r.dot(q.v), c = r2 - s2, d = a * s2 - k.squaredNorm();
    const Vec3 e(std::abs(q.r.y() * q.v.z()) + std::abs(q.r.z() * q.v.y()),
                 std::abs(q.r.z() * q.v.x()) + std::abs(q.r.x() * q.v.z()),
                 std::abs(q.r.x() * q.v.y()) + std::abs(q.r.y() * q.v.x()));
    const double e_b = 8 * u * q.r.cwiseProduct(q.v).cwiseAbs().sum(), e_c = 8 * u * (r2 + s2);
    const double e_d = 12 * u * (a * s2 + k.squaredNorm()) + 10 * u * k.cwiseAbs().dot(e) + 100 * u * u * e.dot(e);
    const double root = std::sqrt(d), den = root - b;
    return 2 * ((e_c * den * root + c * (e_b * root + e_d)) / (c * den * root) + 8 * u);
}

template <class Generate>
Tally run(std::uint64_t seed, int count, Generate&& generate)
{
    Random random(seed);
    Tally tally;
    for (int i = 0; i < count; ++i) {
        const Query q = generate(random);
        const test::Truth truth = test::exact_sphere_sphere(q.r, q.v, q.s);
        const Root root = sphere_sphere_root(q.r, q.v, q.s);
        const bool textbook = !std::isnan(test::textbook_sphere_sphere(q.r, q.v, q.s));
        const bool hit = root.kind == RootKind::impact;
        ++tally.queries;
        tally.hits += truth.impact;
        tally.textbook_missed += truth.impact && !textbook;
        tally.textbook_spurious += !truth.impact && textbook;
        if (truth.open) {
            ++tally.open;
            continue;
        }
        tally.missed += truth.impact && !hit;
        tally.spurious += !truth.impact && hit;
        if (truth.impact && hit) {
            tally.worst = std::max(tally.worst, test::ulps(root.t, truth.t));
            const auto error = test::Float200(abs(test::Float200(root.t) - truth.t));
            if (root.level == 0 && error > level_0_bound(q) * truth.t) ++tally.beyond_bound;
        }
    }
    return tally;
}

void require_exact(const Tally& tally, double worst_ulps)
{
    INFO("hits " << tally.hits << " of " << tally.queries << ", open " << tally.open << ", worst " << tally.worst
                 << " ulp");
    CHECK(tally.missed == 0);
    CHECK(tally.spurious == 0);
    CHECK(tally.beyond_bound == 0);
    CHECK(tally.worst <= worst_ulps);
    CHECK(tally.open <= tally.queries / 50);
}

}  // namespace

TEST_CASE("generic and head-on impacts are found, to 34 ulp")
{
    const Tally generic = run(1, 10000, [](Random& x) {
        return passing(x, x.uniform(0.1, 2), x.uniform(0, 2), x.uniform(1.5, 20), x.uniform(0.1, 10));
    });
    require_exact(generic, 34);
    CHECK(generic.hits > 4000);
    CHECK(generic.hits < 6000);
    const Tally head_on = run(2, 5000, [](Random& x) { return passing(x, 1, 0, x.uniform(1.5, 20), 1); });
    require_exact(head_on, 34);
    CHECK(head_on.hits == head_on.queries);
}

TEST_CASE("grazing impacts within 1e-6, 1e-9, 1e-13 and 4e-16 are told from near misses")
{
    int textbook_wrong = 0;
    for (const double delta : {1e-6, 1e-9, 1e-13, 4e-16}) {
        const Tally tally = run(3, 5000, [delta](Random& x) {
            return passing(x, x.uniform(0.1, 2), 1 + x.uniform(-delta, delta), x.uniform(0.5, 10), x.uniform(0.1, 10));
        });
        INFO("delta " << delta);
        require_exact(tally, 34);
        CHECK(tally.hits > 1000);
        CHECK(tally.hits < 4000);
        textbook_wrong += tally.textbook_missed + tally.textbook_spurious;
    }
    // The positive control: these families do defeat the formula that everybody writes first.
    CHECK(textbook_wrong > 500);
}

TEST_CASE("touching or overlapping spheres collide now if and only if they approach")
{
    int textbook_missed = 0;
    for (const double gap : {0.0, -1e-14, -1e-9, -0.3}) {
        const Tally approach = run(4, 4000, [gap](Random& x) { return touching(x, gap, -x.log_uniform(1e-9, 10)); });
        const Tally separate = run(5, 4000, [gap](Random& x) { return touching(x, gap, x.log_uniform(1e-9, 10)); });
        INFO("gap " << gap);
        require_exact(approach, gap == 0 ? 8 : 0);
        require_exact(separate, gap == 0 ? 8 : 0);
        if (gap < 0) {
            CHECK(approach.hits > approach.queries * 9 / 10);
            CHECK(separate.hits == 0);
        }
        textbook_missed += approach.textbook_missed;
    }
    CHECK(textbook_missed > 4000);
}

TEST_CASE("a gap of 1e-14 and an approach speed of 1e-12 are what they are")
{
    const Tally gap = run(6, 5000, [](Random& x) { return touching(x, 1e-14, -x.log_uniform(1e-3, 10)); });
    require_exact(gap, 2);
    CHECK(gap.hits > 4000);
    require_exact(run(7, 5000, [](Random& x) { return touching(x, x.uniform(-1e-13, 1e-13), x.sign() * 1e-12); }), 34);
    require_exact(run(8, 5000, [](Random& x) { return touching(x, x.log_uniform(1e-4, 0.1), -1); }), 20000);
}

TEST_CASE("speeds from 1e-12 to 1e12 and a radius ratio of 1e6 change nothing")
{
    require_exact(
        run(9, 5000,
            [](Random& x) { return passing(x, 1, x.uniform(0, 1.5), x.uniform(1.5, 20), x.log_uniform(1e-12, 1e12)); }),
        34);
    require_exact(
        run(10, 5000,
            [](Random& x) { return passing(x, 1 + 1e-6, 1 + x.uniform(-1e-6, 1e-6), x.uniform(1.5, 20), 1); }),
        34);
}

TEST_CASE("impacts 1e6 to 1e10 contact distances away are found")
{
    const Tally far = run(11, 8000, [](Random& x) {
        return passing(x, x.uniform(0.1, 2), x.uniform(0, 2), x.log_uniform(1e6, 1e10), x.uniform(0.1, 10));
    });
    require_exact(far, 34);
    CHECK(far.textbook_missed + far.textbook_spurious > 500);
    require_exact(
        run(12, 4000, [](Random& x) { return passing(x, 1, 1 + x.uniform(-1e-9, 1e-9), x.log_uniform(1e6, 1e8), 1); }),
        34);
}

TEST_CASE("lengths of 1e-160 and 1e150 neither underflow nor overflow")
{
    for (const double length : {1e-160, 1e150}) {
        INFO("length " << length);
        const Tally tally = run(13, 4000, [length](Random& x) {
            return passing(x, length * x.uniform(0.1, 2), x.uniform(0, 2), x.uniform(1.5, 20), length);
        });
        require_exact(tally, 34);
        CHECK(tally.hits > 1500);
        const Tally slow = run(14, 4000, [length](Random& x) {
            return passing(x, length * x.uniform(0.1, 2), x.uniform(0, 2), x.uniform(1.5, 20), 1);
        });
        require_exact(slow, 34);
    }
}

TEST_CASE("signs that no double-double can tell are taken exactly")
{
    // Beside 1 the decisive part is 1e-200, its square beyond the range of doubles.
    const double e = 1e-200;
    CHECK(sphere_sphere_root({1, e, 0}, {-1, 0, 0}, 1).kind == RootKind::impact);  // C = e^2 > 0: later than now ...
    CHECK(sphere_sphere_root({1, e, 0}, {-1, 0, 0}, 1).level == 2);
    CHECK(sphere_sphere_root({1, e, 0}, {e, -1, 0}, 1).kind == RootKind::none);  // B = 0
    CHECK(sphere_sphere_root({1, e, 0}, {0, -1, 0}, 1).kind == RootKind::none);  // D = 0: grazes
    const Root tiny = sphere_sphere_root({1, e, 0}, {-e, -1, 0}, 1);             // D = 3 e^2, C = e^2, B = -2 e
    CHECK(tiny.kind == RootKind::impact);
    CHECK(tiny.level == 2);
    CHECK(tiny.t == Approx(e / (2 + std::sqrt(3))).epsilon(1e-15));
    CHECK(approach_sign({1, e, 0}, {e, -1, 0}) == 0);
    CHECK(approach_sign({1, e, e}, {e, -1, e}) == 1);
    CHECK(approach_sign({1, e, e}, {e, -1, -e}) == -1);
    CHECK(approach_sign({1, 0x1p-60, 0x1p-106}, {0x1p-106, -0x1p-46, 0x1p-120}) == 1);
    // 2^-110 of a gap, and of an overlap.
    CHECK(sphere_sphere_root({1, 0x1p-55, 0}, {-1, 0, 0}, 1).t > 0);
    CHECK(sphere_sphere_root({1, 0x1p-55, 0}, {1, -0x1p-54, 0}, 1).kind == RootKind::none);
}

namespace {

/// Integer matrix with orthogonal columns of length a^2+b^2+c^2+d^2 (Euler, Rodrigues).
Eigen::Matrix3d integer_rotation(int a, int b, int c, int d)
{
    Eigen::Matrix3d m;
    m << a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c),  //
        2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b),   //
        2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d;
    return m;
}

}  // namespace

TEST_CASE("on integer lattices, where discriminant and gap are exactly 0, the answer is exact")
{
    Random random(15);
    for (int i = 0; i < 2000; ++i) {
        const int a = random.integer(1, 9), b = random.integer(-9, 9), c = random.integer(-9, 9),
                  d = random.integer(-9, 9);
        const Eigen::Matrix3d m = integer_rotation(a, b, c, d);
        const double n = a * a + b * b + c * c + d * d;
        const auto ask = [&](const Vec3& r, const Vec3& v, double s) {
            return sphere_sphere_root(m * r, m * v, n * s);
        };
        const double far = random.integer(6, 1000000), v = random.integer(1, 1000);
        // Passing at exactly the contact distance is no impact.
        CHECK(ask({-far, 3, 4}, {v, 0, 0}, 5).kind == RootKind::none);
        CHECK(ask({-far, 3, 4}, {v, 0, 0}, 5).level == 2);
        // 3-4-5: contact at x = -4 exactly.
        const Root root = ask({-4 - 2 * v, 3, 0}, {v, 0, 0}, 5);
        CHECK(root.kind == RootKind::impact);
        CHECK(root.t == Approx(2).epsilon(1e-14));
        // Touching exactly: approaching is now, tangential and separating is never.
        const Root now = ask({-4, 3, 0}, {v, 0, 0}, 5);
        CHECK(now.kind == RootKind::impact);
        CHECK(now.t == 0);
        CHECK(ask({-4, 3, 0}, {3 * v, 4 * v, 0}, 5).kind == RootKind::none);
        CHECK(ask({-4, 3, 0}, {-v, 0, 0}, 5).kind == RootKind::none);
        CHECK(ask({-far, 3, 0}, {0, 0, 0}, 5).kind == RootKind::none);
        CHECK(approach_sign(m * Vec3(-4, 3, 0), m * Vec3(3 * v, 4 * v, 0)) == 0);
    }
}

TEST_CASE("swapping the spheres or scaling by powers of two changes no bit of the answer")
{
    Random random(16);
    int impacts = 0;
    for (int i = 0; i < 3000; ++i) {
        const Query q = passing(random, random.uniform(0.1, 2),
                                i % 3 == 0 ? 1 + random.uniform(-1e-13, 1e-13) : random.uniform(0, 1.2),
                                random.log_uniform(1.1, 1e4), random.uniform(0.1, 10));
        const Root root = sphere_sphere_root(q.r, q.v, q.s);
        impacts += root.kind == RootKind::impact;
        const Root swapped = sphere_sphere_root(-q.r, -q.v, q.s);
        CHECK(swapped.kind == root.kind);
        CHECK(swapped.t == root.t);
        const int length = random.integer(-600, 600), time = random.integer(-300, 300);
        const double l = std::ldexp(1, length), w = std::ldexp(1, length - time);
        const Root scaled = sphere_sphere_root(l * q.r, w * q.v, l * q.s);
        CHECK(scaled.kind == root.kind);
        CHECK(scaled.t == std::ldexp(root.t, time));
    }
    CHECK(impacts > 1500);
}

TEST_CASE("the sign of approach is exact where double arithmetic cancels")
{
    Random random(17);
    int textbook_wrong = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec3 r = random.in_cube(1);
        Vec3 v = random.across(r.normalized());
        v += (random.uniform(-1, 1) * 1e-16) * r;
        const test::Float200 b = test::dot(test::lift<test::Float200>(r), test::lift<test::Float200>(v));
        if (abs(b) < 1e-30) continue;
        const int sign = b < 0 ? -1 : 1;
        CHECK(approach_sign(r, v) == sign);
        textbook_wrong += (r.dot(v) < 0 ? -1 : r.dot(v) > 0 ? 1 : 0) != sign;
    }
    CHECK(textbook_wrong > 100);
}
