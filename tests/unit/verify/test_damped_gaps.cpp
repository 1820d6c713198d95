#include "support/damped_law.hpp"
#include "support/random.hpp"
#include "verify/pair_gap.hpp"
#include "verify/plane_gap.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace carom;
using namespace carom::test;
using namespace carom::verification;

namespace {

using Real = Float<100>;

Real time_of(const EpochTime& t)
{
    return Real(t.epoch) + Real(t.offset);
}

Real lifted(const DoubleDouble& x)
{
    return Real(x.high) + Real(x.low);
}

/// A flight that comes to a place with a velocity a time after its start, as far as doubles can say that.
Path path_to(const Vec3& place, const Vec3& velocity, const Vec3& a, double k, const EpochTime& start, double t)
{
    const double decay = std::exp(-k * t), way = -std::expm1(-k * t) / k, fall = (t - way) / k;
    Path p;
    p.start = start;
    p.drag = k;
    p.velocity = (velocity - way * a) / decay;
    const Vec3 x = place - way * p.velocity - fall * a;
    for (int i = 0; i < 3; ++i) {
        p.cell[i] = static_cast<std::int64_t>(std::floor(x[i]));
        p.local[i] = x[i] - std::floor(x[i]);
    }
    return p;
}

Real place_on(const Path& p, const Vec3& a, int i, const Real& t)
{
    const DampedTime<Real> effect(Real(p.drag), t - time_of(p.start));
    return effect.place(Real(p.cell[i]) + Real(p.local[i]) + Real(p.local_low[i]),
                        Real(p.velocity[i]) + Real(p.velocity_low[i]), Real(a[i]));
}

Real speed_on(const Path& p, const Vec3& a, int i, const Real& t)
{
    return DampedTime<Real>(Real(p.drag), t - time_of(p.start))
        .speed(Real(p.velocity[i]) + Real(p.velocity_low[i]), Real(a[i]));
}

/// |r|^2 - S^2.
Real square_gap(const PairSegment& s, const Real& t)
{
    Real sum(0);
    for (int i = 0; i < 3; ++i) {
        const Real r = place_on(s.a, s.acceleration_a, i, t) - place_on(s.b, s.acceleration_b, i, t);
        sum += r * r;
    }
    const Real contact = Real(s.radius_a) + Real(s.radius_b);
    return sum - contact * contact;
}

/// Its least value under one acceleration, where |r|^2 is a parabola in (1 - exp(-k t))/k.
Real least_square_gap(const PairSegment& s)
{
    const Real from = time_of(s.from), to = time_of(s.to), end = DampedTime<Real>(Real(s.a.drag), to - from).s;
    Real rv(0), vv(0);
    for (int i = 0; i < 3; ++i) {
        const Real r = place_on(s.a, s.acceleration_a, i, from) - place_on(s.b, s.acceleration_b, i, from);
        const Real v = speed_on(s.a, s.acceleration_a, i, from) - speed_on(s.b, s.acceleration_b, i, from);
        rv += r * v;
        vv += v * v;
    }
    const Real way = vv > 0 ? std::max(Real(0), std::min(Real(-rv / vv), end)) : Real(0);
    return square_gap(s, from) + way * (2 * rv + way * vv);
}

Real height_on(const WallSegment& s, const Real& t)
{
    Real h = -Real(s.wall.offset) - Real(s.radius);
    for (int i = 0; i < 3; ++i) h += Real(s.wall.normal[i]) * place_on(s.path, s.acceleration, i, t);
    return h;
}

/// The least height: at an end, or where the speed is 0.
Real least_height(const WallSegment& s)
{
    const Real from = time_of(s.from), to = time_of(s.to), k(s.path.drag);
    Real w(0), g(0);
    for (int i = 0; i < 3; ++i) {
        w += Real(s.wall.normal[i]) * speed_on(s.path, s.acceleration, i, from);
        g += Real(s.wall.normal[i]) * Real(s.acceleration[i]);
    }
    Real least = std::min(height_on(s, from), height_on(s, to));
    const Real part = k * w / (g - k * w);  // -k s where w d + g s = 0
    if (w < 0 && g > 0) {
        const Real still = from - log1p(part) / k;
        if (still < to) least = std::min(least, height_on(s, still));
    }
    return least;
}

double drag_of(Random& random)
{
    return random.log_uniform(1e-9, 30);
}

}  // namespace

TEST_CASE("the effect of a damped time is that of 100 digits, within the bounds that proofs use", "[verify][drag]")
{
    Random random(1);
    const Real square = pow(Real(2), -106);
    Real way(0), fall(0), decay(0), coarse(0);
    for (int i = 0; i < 100000; ++i) {
        const double k = random.log_uniform(1e-12, 1e6), t = random.log_uniform(1e-18, 1e3) / k;
        const DoubleDouble time(t, t * random.uniform(-0.5, 0.5) * 0x1p-53);
        const DampedTime<Real> known(Real(k), lifted(time));
        const Damped<DoubleDouble> fine = damped<DoubleDouble>(k, time);
        way = std::max(way, Real(abs(lifted(fine.way) / known.s - 1) / square));
        fall = std::max(fall, Real(abs(lifted(fine.fall) - known.q) / (lifted(time) * lifted(time)) / square));
        decay = std::max(decay, Real(abs(lifted(fine.decay) - known.d) / square));
        const Damped<double> rough = damped<double>(k, time);
        coarse = std::max({coarse, Real(abs(rough.way / known.s - 1)),
                           Real(abs(rough.fall - known.q) / (lifted(time) * lifted(time))),
                           Real(abs(rough.decay - known.d))});
    }
    INFO("errors in u^2: way " << way << ", fall " << fall << ", decay " << decay << "; in double " << coarse);
    CHECK(way < 40);
    CHECK(fall < 30);
    CHECK(decay < 20);
    CHECK(coarse < Real(2 * 0x1p-53));
}

TEST_CASE("places and speeds of 100,000 throws with drag are those of 100 digits, within their error bounds",
          "[verify][drag]")
{
    Random random(2);
    double worst = 0, worst_fine = 0;
    for (int n = 0; n < 100000; ++n) {
        Path p;
        p.drag = random.log_uniform(1e-12, 100);
        p.start = {random.integer(0, 1000), random.uniform(0, 1)};
        p.cell[0] = random.integer(-1000, 1000);
        p.local[0] = random.uniform(0, 1);
        p.velocity[0] = random.uniform(-3, 3);
        const Vec3 a(random.uniform(-1, 1), 0, 0);
        const double time = random.log_uniform(1e-6, 1e3);
        const EpochTime at{p.start.epoch + static_cast<std::int64_t>(time), random.uniform(0, 1)};
        if (at < p.start) continue;
        const std::int64_t base[3] = {0, 0, 0};
        const Real place = place_on(p, a, 0, time_of(at)), speed = speed_on(p, a, 0, time_of(at));
        const Moving<double> rough = moving<double>(p, a, base, at);
        const Moving<DoubleDouble> fine = moving<DoubleDouble>(p, a, base, at);
        const auto error = [](const Real& found, const Real& known, double bound) {
            return Real(abs(found - known) / bound).convert_to<double>();
        };
        worst = std::max({worst, error(Real(rough.place.x), place, rounding<double> * rough.place_size[0]),
                          error(Real(rough.speed.x), speed, rounding<double> * rough.speed_size[0])});
        worst_fine =
            std::max({worst_fine, error(lifted(fine.place.x), place, rounding<DoubleDouble> * fine.place_size[0]),
                      error(lifted(fine.speed.x), speed, rounding<DoubleDouble> * fine.speed_size[0])});
    }
    INFO("largest error beside its bound: " << worst << " in double, " << worst_fine << " in double-double");
    CHECK(worst < 1);
    CHECK(worst_fine < 1);
    CHECK(worst_fine > 1e-3);  // a bound that means something
}

TEST_CASE("the grade of a pair of damped flights is that of 100 digits", "[verify][drag]")
{
    Random random(3);
    int seen[6] = {};
    const Vec3 gravity(0, 0, -0.3);
    for (int i = 0; i < 4000; ++i) {
        // Backwards from a nearest approach at time t at a distance of (1 + miss) S.
        const double misses[] = {0, 1e-17, -1e-17, 1e-14, -1e-14, 1e-6, -1e-6, 0.5};
        const double miss = misses[i % 8], contact = 0.9, k = drag_of(random),
                     t = random.uniform(0, std::min(3.0, 3 / k));
        const Vec3 direction = random.direction(), v = random.uniform(0, 1) * random.across(direction);
        const Vec3 centre = random.in_cube(5), drift = random.in_cube(1);
        const EpochTime late{0, random.uniform(0, std::min(t, 0.9))};
        Path a = path_to(centre + contact * (1 + miss) * direction, v + drift, gravity, k, {}, t);
        Path b = path_to(centre, drift, gravity, k, late, t - late.offset);
        a.acceleration = b.acceleration = 1;
        const EpochTime from{0, random.uniform(late.offset, 1)}, to{random.integer(1, 3), 0.25};
        const PairSegment s{a, b, gravity, gravity, from, to, 0.5, 0.4, nullptr, nullptr};
        const Real least = least_square_gap(s);
        constexpr double bound = 1e-14;
        const GapFound found = examine(s, bound);
        ++seen[static_cast<int>(found.grade)];
        const Real allowed = Real(contact - bound) * Real(contact - bound) - Real(contact) * Real(contact);
        if (found.grade == Grade::exact) CHECK(least >= 0);
        if (found.grade == Grade::violated) CHECK(least < allowed * Real(0.999));
        if (found.grade == Grade::bounded) CHECK((least >= allowed * Real(1.001) && least < Real(1e-25)));
        const Real gap = sqrt(Real(least + Real(contact) * Real(contact))) - Real(contact);
        CHECK(abs(Real(gap - Real(found.gap))) <= 1e-24 + 1e-14 * std::abs(found.gap));
        if (is_clear(s, 0)) CHECK(least > 0);
    }
    CHECK(seen[static_cast<int>(Grade::exact)] > 500);
    CHECK(seen[static_cast<int>(Grade::bounded)] > 50);
    CHECK(seen[static_cast<int>(Grade::violated)] > 100);
    CHECK(seen[static_cast<int>(Grade::not_certified)] == 0);
}

TEST_CASE("the grade of a damped flight and a plane is that of 100 digits", "[verify][drag]")
{
    Random random(4);
    int seen[6] = {}, between_ends = 0;
    for (int i = 0; i < 8000; ++i) {
        // Towards the plane and pulled away from it, or the other way round; lowest at time t, or at an end.
        const double misses[] = {0, 1e-17, -1e-17, 1e-14, -1e-14, 1e-6, -1e-6, 0.5};
        const double k = drag_of(random), t = random.uniform(0, std::min(3.0, 20 / k)), radius = 0.5;
        Wall wall;
        wall.normal = random.direction();
        wall.offset = random.uniform(-3, 3);
        const Vec3 a =
            (i % 3 == 0 ? -1 : 1) * random.uniform(0, 1) * wall.normal + random.uniform(0, 1) * random.in_cube(1);
        const double towards = i % 5 == 0 ? random.uniform(-1, 1) : 0;
        const Vec3 place = (wall.offset + radius + misses[i % 8]) * wall.normal + 3 * random.across(wall.normal);
        Path p = path_to(place, random.across(wall.normal) + towards * wall.normal, a, k, {}, t);
        p.acceleration = 1;
        const EpochTime from{0, random.uniform(0, 0.5)}, to{random.integer(1, 3), 0.25};
        const WallSegment s{p, a, wall, 1, from, to, radius, nullptr};
        const Real least = least_height(s);
        between_ends += least < std::min(height_on(s, time_of(from)), height_on(s, time_of(to)));
        constexpr double bound = 1e-13;
        const GapFound found = examine(s, bound);
        ++seen[static_cast<int>(found.grade)];
        INFO("k " << k << ", t " << t << ", least " << least << ", found " << found.gap << ", grade "
                  << static_cast<int>(found.grade));
        if (found.grade == Grade::exact) CHECK(least >= 0);
        if (found.grade == Grade::violated) CHECK(least < -bound);
        if (found.grade == Grade::bounded) CHECK((least >= -bound && least < Real(1e-25)));
        CHECK(abs(Real(least - Real(found.gap))) <= 1e-28 * (1 + p.velocity.norm()) + 1e-14 * std::abs(found.gap));
        if (is_clear(s, 0)) CHECK(least > 0);
        CHECK(Real(largest_distance(s)) >= abs(least));
    }
    CHECK(between_ends > 500);
    CHECK(seen[static_cast<int>(Grade::exact)] > 1000);
    CHECK(seen[static_cast<int>(Grade::bounded)] > 100);
    CHECK(seen[static_cast<int>(Grade::violated)] > 300);
    CHECK(seen[static_cast<int>(Grade::not_certified)] < 40);
}

TEST_CASE("with drag and unequal accelerations a lower bound is one, and sharp enough", "[verify][drag]")
{
    Random random(5);
    int exact = 0, violated = 0, open = 0;
    const Vec3 gravity(0, 0, -0.5), none = Vec3::Zero();
    for (int i = 0; i < 1000; ++i) {
        // b hangs still, a falls past it, or touches it at time t.
        const double misses[] = {0.3, 1e-3, 1e-9, -1e-9, -1e-3};
        const double k = drag_of(random), t = random.uniform(0.1, std::min(2.0, 5 / k)), contact = 0.9;
        const Vec3 direction = random.direction();
        Path a = path_to(contact * (1 + misses[i % 5]) * direction, random.across(direction), gravity, k, {}, t);
        Path b = path_to(none, none, none, k, {}, 0);
        a.acceleration = 1;
        const PairSegment s{a, b, gravity, none, {}, {2, 0.5}, 0.5, 0.4, nullptr, nullptr};
        const GapFound found = examine(s, 1e-14);
        Real least = square_gap(s, Real(t));
        for (int n = 0; n <= 50; ++n) least = std::min(least, square_gap(s, Real(2.5) * n / 50));
        if (found.grade == Grade::exact) CHECK(least >= 0);
        if (found.grade == Grade::violated) CHECK(least < Real(1e-9));
        if (is_clear(s, 0)) CHECK(least > 0);
        exact += found.grade == Grade::exact;
        violated += found.grade == Grade::violated;
        open += found.grade == Grade::not_certified;
        if (least < Real(-1e-12)) CHECK(found.grade == Grade::violated);
    }
    CHECK(exact > 125);
    CHECK(violated > 125);
    CHECK(open == 0);
}
