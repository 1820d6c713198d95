#include "adversary/families.hpp"
#include "support/random.hpp"
#include "toi/level_0.hpp"
#include "unit/toi/oracle.hpp"

#include <carom/error.hpp>
#include <carom/time_of_impact.hpp>
#include <catch2/catch.hpp>

#include <limits>
#include <vector>

using namespace carom;
using carom::test::Float200;
using carom::test::Random;

namespace {

struct Pairs {
    std::vector<double> rx, ry, rz, vx, vy, vz, s;

    std::size_t size() const { return s.size(); }
    void add(const Vec3& r, const Vec3& v, double contact_distance)
    {
        rx.push_back(r.x());
        ry.push_back(r.y());
        rz.push_back(r.z());
        vx.push_back(v.x());
        vy.push_back(v.y());
        vz.push_back(v.z());
        s.push_back(contact_distance);
    }
    RelativeMotions view() const { return {rx, ry, rz, vx, vy, vz, s}; }
    Vec3 r(std::size_t i) const { return {rx[i], ry[i], rz[i]}; }
    Vec3 v(std::size_t i) const { return {vx[i], vy[i], vz[i]}; }
};

struct Times {
    std::vector<ImpactStatus> status;
    std::vector<double> t, t_lo, t_hi;

    explicit Times(std::size_t n) : status(n, ImpactStatus::touching), t(n, -1), t_lo(n, -1), t_hi(n, -1) {}
    ImpactTimes view() { return {status, t, t_lo, t_hi}; }
};

/// From every family, and what lies in no range at all.
Pairs hard_pairs(int each)
{
    Pairs pairs;
    Random random(11);
    for (const auto& family : test::sphere_families())
        for (int i = 0; i < each; ++i) {
            const test::Query q = family.make(random);
            pairs.add(q.a.position - q.b.position, q.a.velocity - q.b.velocity, q.a.radius + q.b.radius);
        }
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    for (const double x : {inf, nan, 1e308, 0.0, 5e-324}) {
        pairs.add({x, 1, 1}, {-1, 0, 0}, 1);
        pairs.add({3, 0, 0}, {-x, 0, 0}, 1);
        pairs.add({3, 0, 0}, {-1, 0, 0}, x);
        pairs.add({3, 0, 0}, {-1, x, -x}, 1);
    }
    return pairs;
}

}  // namespace

TEST_CASE("a batch answers each pair as it would be answered alone, to the last bit", "[batch]")
{
    const Pairs pairs = hard_pairs(333);
    REQUIRE(pairs.size() % 128 != 0);
    Times times(pairs.size()), lower(pairs.size());
    time_of_impact_batch(pairs.view(), times.view());
    lower_bound_batch(pairs.view(), lower.view());
    int impacts = 0, touching = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const ImpactTime alone = quick_time_of_impact(pairs.r(i), pairs.v(i), pairs.s[i]);
        REQUIRE(times.status[i] == alone.status);
        REQUIRE(times.t[i] == alone.t);
        REQUIRE(times.t_lo[i] == alone.t_lo);
        REQUIRE(times.t_hi[i] == alone.t_hi);
        REQUIRE(lower.status[i] == alone.status);
        REQUIRE(lower.t[i] == -1);
        impacts += alone.status == ImpactStatus::impact;
        touching += alone.status == ImpactStatus::touching;
    }
    CHECK(impacts > 2000);
    CHECK(touching > 400);
}

TEST_CASE("intervals and lower bounds of a batch contain the exact times, and no pair is misjudged", "[batch]")
{
    const Pairs pairs = hard_pairs(200);
    Times times(pairs.size()), lower(pairs.size());
    time_of_impact_batch(pairs.view(), times.view());
    lower_bound_batch(pairs.view(), lower.view());
    for (std::size_t i = 0; i + 20 < pairs.size(); ++i) {
        const auto r = test::lift<Float200>(pairs.r(i)), v = test::lift<Float200>(pairs.v(i));
        if (i >= 24 * 200) break;  // the last family needs more digits
        const Float200 s = pairs.s[i], a = test::dot(v, v), b = test::dot(r, v), c = test::dot(r, r) - s * s,
                       d = b * b - a * c;
        const bool hit = b < 0 && (c <= 0 || d > 0);
        CAPTURE(i, pairs.r(i).transpose(), pairs.v(i).transpose(), pairs.s[i], times.t[i]);
        const Float200 t = hit && c > 0 ? Float200(c / (sqrt(d) - b)) : Float200(0);
        if (t > std::numeric_limits<double>::max()) continue;
        REQUIRE(hit == (times.status[i] != ImpactStatus::none));
        if (!hit) continue;
        REQUIRE((c > 0) == (times.status[i] == ImpactStatus::impact));
        REQUIRE((Float200(times.t_lo[i]) <= t && t <= Float200(times.t_hi[i])));
        REQUIRE((Float200(lower.t_lo[i]) <= t && t <= Float200(lower.t_lo[i]) * 2 + 1e-300));
    }
}

TEST_CASE("batches of any length are answered, none written beyond its end, and arrays of other lengths refused",
          "[batch]")
{
    for (const std::size_t n : {0U, 1U, 3U, 127U, 128U, 129U, 300U}) {
        Pairs pairs;
        for (std::size_t i = 0; i < n; ++i) pairs.add({4.0 + static_cast<double>(i), 0, 0}, {-1, 0, 0}, 1);
        Times times(n + 1);
        ImpactTimes out = times.view();
        out = {out.status.first(n), out.t.first(n), out.t_lo.first(n), out.t_hi.first(n)};
        time_of_impact_batch(pairs.view(), out);
        for (std::size_t i = 0; i < n; ++i) CHECK(times.t[i] == Approx(3.0 + static_cast<double>(i)).epsilon(1e-15));
        CHECK(times.t[n] == -1);
        CHECK(times.t_lo[n] == -1);
        CHECK(times.t_hi[n] == -1);
        CHECK(times.status[n] == ImpactStatus::touching);
        CHECK_THROWS_AS(time_of_impact_batch(pairs.view(), times.view()), InputError);
        CHECK_THROWS_AS(lower_bound_batch(pairs.view(), times.view()), InputError);
    }
}
