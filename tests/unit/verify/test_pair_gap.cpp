#include "support/multiprecision.hpp"
#include "support/random.hpp"
#include "verify/pair_gap.hpp"
#include "verify/quick_look.hpp"

#include <catch2/catch.hpp>

using namespace carom;
using namespace carom::test;
using namespace carom::verification;

namespace {

Path path_at(const Vec3& place, const Vec3& velocity, const EpochTime& start = {})
{
    Path p;
    p.start = start;
    for (int k = 0; k < 3; ++k) {
        p.cell[k] = static_cast<std::int64_t>(std::floor(place[k]));
        p.local[k] = place[k] - std::floor(place[k]);
    }
    p.velocity = velocity;
    return p;
}

using Real = Float200;

/// |r|^2 - S^2 at a time after the start of the epochs.
Real square_gap(const PairSegment& s, const Real& t)
{
    Real sum(0);
    for (int k = 0; k < 3; ++k) {
        const auto place = [&](const Path& p, const Vec3& a) {
            const Real tau = t - Real(p.start.epoch) - Real(p.start.offset);
            return Real(Real(p.cell[k]) + Real(p.local[k]) + Real(p.local_low[k]) +
                        tau * (Real(p.velocity[k]) + Real(p.velocity_low[k]) + tau * Real(a[k]) / 2));
        };
        const Real r = place(s.a, s.acceleration_a) - place(s.b, s.acceleration_b);
        sum += r * r;
    }
    const Real contact = Real(s.radius_a) + Real(s.radius_b);
    return sum - contact * contact;
}

Real time_of(const EpochTime& t)
{
    return Real(t.epoch) + Real(t.offset);
}

/// Its least value, under equal accelerations: a parabola through three times.
Real least_square_gap(const PairSegment& s)
{
    const Real from = time_of(s.from), to = time_of(s.to), half = (to - from) / 2;
    const Real f0 = square_gap(s, from), f1 = square_gap(s, from + half), f2 = square_gap(s, to);
    const Real a = (f0 - 2 * f1 + f2) / (2 * half * half), b = (f1 - f0) / half - a * half;
    Real t = a > 0 ? Real(-b / (2 * a)) : Real(0);
    t = std::max(Real(0), std::min(t, Real(to - from)));
    return std::min({f0, f2, Real(f0 + t * (b + a * t))});
}

}  // namespace

TEST_CASE("the grade of a pair of flights is that of many digits", "[verify]")
{
    Random random(2);
    int seen[6] = {}, levels[3] = {}, quick = 0;
    const Vec3 gravity(0, 0, -0.3);
    for (int i = 0; i < 20000; ++i) {
        // Backwards from a nearest approach at time t at a distance of (1 + miss) S.
        const double misses[] = {0, 1e-17, -1e-17, 1e-14, -1e-14, 1e-6, -1e-6, 0.5};
        const double miss = misses[i % 8], contact = 0.9;
        Vec3 direction = random.in_cube(1);
        direction.normalize();
        Vec3 v = random.in_cube(1);
        v -= v.dot(direction) * direction;
        const double t = random.uniform(0, 3);
        const Vec3 centre = random.in_cube(5), drift = random.in_cube(1);
        const Vec3 r = contact * (1 + miss) * direction;
        Path a = path_at(centre + r - t * (v + drift) - 0.5 * t * t * gravity, v + drift + t * gravity);
        Path b = path_at(centre - t * drift - 0.5 * t * t * gravity, drift + t * gravity);
        a.acceleration = b.acceleration = 1;
        const double length = random.uniform(0, 2);
        const EpochTime from{0, random.uniform(0, 0.5)}, to{static_cast<std::int64_t>(1 + length), 0.25};
        const PairSegment s{a, b, gravity, gravity, from, to, 0.5, 0.4, nullptr, nullptr};
        const Real least = least_square_gap(s);
        const double bound = 1e-14;
        const GapFound found = examine(s, bound);
        ++seen[static_cast<int>(found.grade)];
        ++levels[static_cast<int>(found.level)];
        CHECK((found.grade == Grade::exact) == (least >= 0));
        const Real allowed = Real(contact - bound) * Real(contact - bound) - Real(contact) * Real(contact);
        if (found.grade == Grade::violated) CHECK(least < allowed * Real(0.999));
        if (found.grade == Grade::bounded) CHECK(least >= allowed * Real(1.001));
        const Real gap = sqrt(Real(least + Real(contact) * Real(contact))) - Real(contact);
        CHECK(std::abs(Real(gap - Real(found.gap)).convert_to<double>()) <= 1e-25 + 1e-14 * std::abs(found.gap));
        if (is_clear(s, 0)) CHECK(least > 0);
        const Quick qa = quick_look_at(a, gravity, {}), qb = quick_look_at(b, gravity, {});
        const double t0 = between<double>({}, from), t1 = between<double>({}, to);
        if (is_far(qa, qb, t0, t1, contact, 0)) {
            CHECK(least > 0);
            ++quick;
        }
    }
    CHECK(seen[static_cast<int>(Grade::exact)] > 1000);
    CHECK(seen[static_cast<int>(Grade::bounded)] > 100);
    CHECK(seen[static_cast<int>(Grade::violated)] > 1000);
    CHECK(quick > 5000);
}

TEST_CASE("contact that is exact is seen as exact, at any distance in time", "[verify]")
{
    // 3, 4, 5: the spheres touch to the last bit at the start, and again they graze.
    Path a = path_at({3, 4, 0}, {0, 0, 1}), b = path_at({0, 0, 0}, {0, 0, 0});
    const Vec3 none = Vec3::Zero();
    const GapFound parting = examine({a, b, none, none, {}, {1000, 0}, 2.5, 2.5, nullptr, nullptr}, 0);
    CHECK(parting.grade == Grade::exact);
    CHECK(parting.level == Level::exact);
    a = path_at({3, 4, -7}, {0, 0, 1});
    const GapFound grazing = examine({a, b, none, none, {}, {20, 0}, 2.5, 2.5, nullptr, nullptr}, 0);
    CHECK(grazing.grade == Grade::exact);
    CHECK(grazing.gap == 0);
    a.local_low[0] = -1e-30;  // less than double-double can tell at this size
    const GapFound deeper = examine({a, b, none, none, {}, {20, 0}, 2.5, 2.5, nullptr, nullptr}, 0);
    CHECK(deeper.grade != Grade::exact);
}

TEST_CASE("under unequal accelerations a lower bound is one, and sharp enough", "[verify]")
{
    Random random(3);
    int exact = 0, violated = 0, open = 0;
    const Vec3 gravity(0, 0, -0.5), none = Vec3::Zero();
    for (int i = 0; i < 1000; ++i) {
        // b hangs still, a falls past it, or touches it at `t`.
        const double misses[] = {0.3, 1e-3, 1e-9, -1e-9, -1e-3};
        const double miss = misses[i % 5], contact = 0.9, t = random.uniform(0.1, 2);
        Vec3 direction = random.in_cube(1);
        direction.normalize();
        Vec3 v = random.in_cube(1);
        v -= v.dot(direction) * direction;
        const Vec3 place = contact * (1 + miss) * direction;
        Path a = path_at(place - t * v + 0.5 * t * t * gravity, v - t * gravity), b = path_at(none, none);
        a.acceleration = 1;
        const PairSegment s{a, b, gravity, none, {}, {2, 0.5}, 0.5, 0.4, nullptr, nullptr};
        const GapFound found = examine(s, 1e-14);
        Real least(1e300);
        for (int k = 0; k <= 200; ++k) least = std::min(least, square_gap(s, Real(2.5) * k / 200));
        least = std::min(least, square_gap(s, Real(t)));
        if (found.grade == Grade::exact) CHECK(least >= 0);
        if (found.grade == Grade::violated) CHECK(least < Real(1e-9));
        if (is_clear(s, 0)) CHECK(least > 0);
        exact += found.grade == Grade::exact;
        violated += found.grade == Grade::violated;
        open += found.grade == Grade::not_certified;
        if (least < Real(-1e-12)) CHECK(found.grade == Grade::violated);
        if (least > Real(1e-3)) CHECK(found.grade == Grade::exact);
    }
    CHECK(exact > 125);
    CHECK(violated > 125);
    CHECK(open == 0);
}
