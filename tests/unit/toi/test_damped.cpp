/// Times of impact under linear drag: planes and straight lines against the formulas in 60 digits, curved relative
/// motion against a subdivision of time that knows nothing of its pieces but a bound of the speed.
#include "toi/damped_plane.hpp"
#include "toi/damped_sphere_sphere.hpp"
#include "toi/tolerances.hpp"

#include "support/multiprecision.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>

using namespace carom;
using namespace carom::test;
using Real = Float<60>;

namespace {

struct Law {
    Real decay, way, fall;
};
Law law(const Real& k, const Real& t)
{
    const Real z = k * t;
    if (z < Real(1e-8)) {  // 60 digits lose none that matter: the series' next term is z^4 / 720
        return {1 - z + z * z / 2 - z * z * z / 6, t * (1 - z / 2 + z * z / 6 - z * z * z / 24),
                t * t * (Real(1) / 2 - z / 6 + z * z / 24 - z * z * z / 120)};
    }
    const Real decay = exp(-z), way = (1 - decay) / k;
    return {decay, way, (t - way) / k};
}

struct Throw {
    double h, w, g, k;
};
Real height(const Throw& x, const Real& t)
{
    const Law d = law(x.k, t);
    return x.h + x.w * d.way + x.g * d.fall;
}

/// The root of a height that falls through 0 once between two times.
Real root_between(const Throw& x, Real low, Real high)
{
    for (int i = 0; i < 40; ++i) {
        const Real middle = (low + high) / 2;
        (height(x, middle) < 0 ? high : low) = middle;
    }
    Real t = high;  // Newton doubles the digits from here
    for (int i = 0; i < 5; ++i) {
        const Law d = law(x.k, t);
        t -= height(x, t) / (x.w * d.decay + x.g * d.way);
    }
    return t;
}

/// The first closing by what is known of one turn: at exp(-k t) = g / (g - k w).
std::optional<Real> exact_answer(const Throw& x)
{
    const Real k = x.k, w = x.w, g = x.g;
    if (x.h <= 0 && x.w < 0) return Real(0);
    if (x.g == 0) {
        if (x.w >= 0 || k * x.h >= -w) return {};
        return Real(-log1p(-k * x.h / -w) / k);
    }
    const Real turn = w == 0 ? Real(0) : Real(log((g - k * w) / g) / k);
    if (x.g > 0) {
        if (x.w >= 0 || height(x, turn) >= 0) return {};
        return root_between(x, 0, turn);
    }
    const Real from = x.w > 0 ? turn : Real(0);
    if (x.h <= 0 && height(x, from) <= 0) return from;
    Real to = from > 0 ? 2 * from : Real(1e-9);
    while (height(x, to) >= 0) to *= 2;
    return root_between(x, from, to);
}

Real3<Real> place_at(const AcceleratedMotion& m, const Law& d)
{
    const Real3<Real> r = lift<Real>(m.r), v = lift<Real>(m.v), a = lift<Real>(m.a);
    Real3<Real> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = r[i] + d.way * v[i] + d.fall * a[i];
    return p;
}
Real gap(const AcceleratedMotion& m, double k, const Real& t)
{
    const Real3<Real> p = place_at(m, law(k, t));
    return sqrt(dot(p, p)) - m.contact_distance;
}

/// The first time up to `end` at which two spheres that are apart overlap by more than `least`, by halving of
/// intervals in which a bound of the speed does not exclude it.
class Subdivision {
public:
    Subdivision(const AcceleratedMotion& m, double k, double least) : m_(m), k_(k), least_(least) {}

    std::optional<double> first(double from, double to, int depth = 0) const
    {
        const long double middle = (static_cast<long double>(from) + to) / 2;
        // The speed is between that at the start and the limit |a|/k, and gains at most |a| t.
        const double speed =
            std::max(speed_at(from), std::min(m_.a.norm() / k_, speed_at(from) + (to - from) * m_.a.norm()));
        const double here = gap_at(static_cast<double>(middle));
        if (here > speed * (to - from) / 2) return {};
        if (here < -least_) {
            if (const auto earlier = depth < 60 ? first(from, static_cast<double>(middle), depth + 1) : std::nullopt)
                return earlier;
            return static_cast<double>(middle);
        }
        if (depth >= 60 || speed * (to - from) < least_) return {};
        if (const auto earlier = first(from, static_cast<double>(middle), depth + 1)) return earlier;
        return first(static_cast<double>(middle), to, depth + 1);
    }

private:
    struct Weights {
        long double decay, way, fall;
    };
    Weights weights(double t) const
    {
        const long double z = static_cast<long double>(k_) * t;
        const long double way = -std::expm1(-z) / k_;
        const long double fall = z < 1e-4L ? t * (t * (0.5L - z / 6 + z * z / 24)) : (t - way) / k_;
        return {std::exp(-z), way, fall};
    }
    double speed_at(double t) const
    {
        const Weights d = weights(t);
        return (static_cast<double>(d.decay) * m_.v + static_cast<double>(d.way) * m_.a).norm();
    }
    double gap_at(double t) const
    {
        const Weights d = weights(t);
        return (m_.r + static_cast<double>(d.way) * m_.v + static_cast<double>(d.fall) * m_.a).norm() -
               m_.contact_distance;
    }

    const AcceleratedMotion& m_;
    const double k_, least_;
};

Throw any_throw(Random& random)
{
    Throw x;
    x.h = random.log_uniform(1e-9, 1e3);
    x.w = random.sign() * random.log_uniform(1e-6, 1e3);
    x.g = random.integer(0, 3) == 0 ? 0 : random.sign() * random.log_uniform(1e-3, 1e3);
    x.k = random.log_uniform(1e-12, 1e6);
    // A way of the order of the height, so that about half of those that coast arrive.
    if (x.g == 0 && random.coin()) x.k = -x.w / x.h * random.uniform(0.5, 1.5) * (x.w < 0 ? 1 : -1);
    return x;
}

}  // namespace

TEST_CASE("a thrown sphere meets a plane under drag when, and only when, the formulas in 60 digits have it do so")
{
    Random random(1);
    double worst = 0;
    int arrivals = 0, wrong = 0;
    for (int i = 0; i < 100000; ++i) {
        const Throw x = any_throw(random);
        const Root root = damped_plane_root(x.h, x.w, x.g, x.k);
        const std::optional<Real> wanted = exact_answer(x);
        if ((root.kind == RootKind::impact) != wanted.has_value()) {
            ++wrong;
            continue;
        }
        if (!wanted) continue;
        ++arrivals;
        // What is left of the speed decides how well a time can be known: 1 where it falls as fast as ever.
        const Law d = law(x.k, *wanted);
        const Real rate = abs(x.w * d.decay + x.g * d.way);
        const Real scale = *wanted + (x.h + abs(x.w) * d.way + abs(x.g) * d.fall) / rate;
        worst = std::max(worst, Real(abs(Real(root.t) - *wanted) / scale / unit_roundoff).convert_to<double>());
    }
    CAPTURE(worst, arrivals);
    CHECK(wrong == 0);
    CHECK(arrivals > 40000);
    CHECK(worst < 8);
}

TEST_CASE("a sphere that has just bounced returns after the whole of its flight, however low")
{
    Random random(2);
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Throw x{0, random.log_uniform(1e-10, 10), -random.log_uniform(1, 100), random.log_uniform(1e-12, 1e6)};
        const Root root = damped_plane_root(x.h, x.w, x.g, x.k);
        REQUIRE(root.kind == RootKind::impact);
        worst = std::max(worst, ulps(root.t, *exact_answer(x)));
        CHECK(damped_plane_root(-1e-30, x.w, x.g, x.k).t == Approx(root.t));
    }
    CAPTURE(worst);
    CHECK(worst < 6);
    CHECK(damped_plane_root(0, 0, -1, 1).kind == RootKind::pressed);
    CHECK(damped_plane_root(0, 1, 0, 1).kind == RootKind::none);
    CHECK(damped_plane_root(-1, 1e-3, -9.81, 1).t == Approx(std::log1p(1e-3 / 9.81)));  // the apex of a path inside
}

TEST_CASE("a sphere that comes to a stand exactly at a plane does not meet it, and one that is one ulp faster does")
{
    CHECK(damped_plane_root(0.75, -1.5, 0, 2).kind == RootKind::none);
    const double faster = std::nextafter(1.5, 2);
    const Root root = damped_plane_root(0.75, -faster, 0, 2);
    REQUIRE(root.kind == RootKind::impact);
    CHECK(ulps(root.t, *exact_answer({0.75, -faster, 0, 2})) < 2);
    CHECK(root.t > 17);  // 52 bits of the speed are gone by then
}

TEST_CASE("two spheres that fly straight relative to each other meet under drag as the quadratic in 60 digits has it")
{
    Random random(3);
    double worst = 0;
    int impacts = 0, late = 0, wrong = 0;
    for (int i = 0; i < 100000; ++i) {
        const double s = random.log_uniform(0.1, 10), distance = s * random.uniform(1.001, 20);
        const Vec3 towards = random.direction();
        const AcceleratedMotion m{
            distance * towards,
            random.log_uniform(1e-3, 1e3) * (-towards + random.uniform(0, 0.3) * random.direction()), Vec3::Zero(), s};
        const double reach = m.v.norm() / distance;
        const double k = random.coin() ? random.log_uniform(1e-12, 1e6) : reach * random.uniform(0.8, 1.4);
        const Real3<Real> r = lift<Real>(m.r), v = lift<Real>(m.v);
        const Real a = dot(v, v), b = dot(r, v), c = dot(r, r) - Real(s) * s, d = b * b - a * c;
        std::optional<Real> wanted;
        if (b < 0 && d > 0) {
            const Real way = c / (sqrt(d) - b);
            if (k * way < 1) wanted = Real(-log1p(-k * way) / k);
        }
        const Root root = damped_sphere_sphere_root(m, k);
        if ((root.kind == RootKind::impact) != wanted.has_value()) {
            ++wrong;
            continue;
        }
        if (!wanted) continue;
        ++impacts;
        late += k * *wanted > 1;
        worst = std::max(worst, ulps(root.t, *wanted));
    }
    CAPTURE(worst, impacts, late);
    CHECK(wrong == 0);
    CHECK(impacts > 30000);
    CHECK(late > 1000);
    // As without drag: level 0 keeps all but 10 bits of a grazing or nearly closed gap, and no fewer.
    CHECK(worst < 1024);
}

TEST_CASE("two spheres that stop exactly as they touch do not meet, and one ulp of speed more makes them")
{
    const AcceleratedMotion touching{{3, 0, 0}, {-4, 0, 0}, Vec3::Zero(), 1};
    CHECK(damped_sphere_sphere_root(touching, 2).kind == RootKind::none);
    AcceleratedMotion faster = touching;
    faster.v.x() = -std::nextafter(4.0, 5);
    const Root root = damped_sphere_sphere_root(faster, 2);
    REQUIRE(root.kind == RootKind::impact);
    CHECK(ulps(root.t, Real(-log1p(-Real(4) / Real(-faster.v.x())) / 2)) < 2);
}

TEST_CASE("of 100,000 throws at a sphere that does not fall with them none is missed, and none is invented")
{
    Random random(4);
    double worst = 0;
    int impacts = 0, missed = 0, invented = 0, late = 0;
    for (int i = 0; i < 100000; ++i) {
        const double s = random.log_uniform(0.1, 10), distance = s * random.uniform(1.0001, 8);
        const Vec3 place = distance * random.direction();
        const double gravity = random.log_uniform(0.1, 100), natural = std::sqrt(distance / gravity);
        const double speed = random.log_uniform(0.1, 10) * distance / natural;
        const double k = random.log_uniform(1e-12, 1e6) / natural;
        const AcceleratedMotion m{place, speed * (-place / distance + random.uniform(0, 2) * random.direction()),
                                  gravity * random.direction(), s};
        const double end = std::min(40 * natural * std::max(1.0, k * natural), 1e6 * natural);
        const Root root = damped_sphere_sphere_root(m, k);
        const std::optional<double> seen = Subdivision(m, k, 1e-9 * s).first(0, end);
        if (root.kind != RootKind::impact) {
            missed += seen.has_value();
            continue;
        }
        if (root.t > end) continue;
        ++impacts;
        // The gap is closed there and opens just before: to rounding of the place, which the speed turns into a time.
        const Real t = root.t;
        const Real rate = (gap(m, k, t * (1 + Real(1e-25))) - gap(m, k, t * (1 - Real(1e-25)))) / (t * Real(2e-25));
        const Real correction = gap(m, k, t) / rate;
        if (rate >= 0) ++invented;
        const Real scale = t + (distance + abs(gap(m, k, 0))) / -rate;
        worst = std::max(worst, Real(abs(correction) / scale / unit_roundoff).convert_to<double>());
        // Nothing before it.
        late += seen && *seen < root.t * (1 - 1e-9);
    }
    CAPTURE(worst, impacts);
    CHECK(missed == 0);
    CHECK(invented == 0);
    CHECK(late == 0);
    CHECK(impacts > 10000);
    CHECK(worst < 10);
}

TEST_CASE("a curved path that grazes a sphere by one part in 1e13 is a hit, and one that clears it by that is none")
{
    Random random(6);
    int hits = 0, misses = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 place = random.uniform(2, 6) * random.direction();
        AcceleratedMotion m{place, random.uniform(1, 6) * (-place.normalized() + 0.4 * random.direction()),
                            random.uniform(0.1, 10) * random.direction(), 0};
        const double k = random.log_uniform(1e-6, 10);
        // The first least distance: where it begins to grow, then Newton's method on the rate p.w in 60 digits.
        Real t = 0;
        const auto rate = [&](const Real& time, Real& slope) {
            const Law d = law(k, time);
            const Real3<Real> x = place_at(m, d), v = lift<Real>(m.v), a = lift<Real>(m.a);
            Real3<Real> w, bend;
            for (std::size_t c = 0; c < 3; ++c) {
                w[c] = d.decay * v[c] + d.way * a[c];
                bend[c] = a[c] - k * w[c];
            }
            slope = dot(w, w) + dot(x, bend);
            return dot(x, w);
        };
        Real slope;
        while (t < 4 && rate(t, slope) < 0) t += Real(1) / 64;
        if (t == 0 || t >= 4) continue;
        for (int n = 0; n < 12; ++n) t -= rate(t, slope) / slope;
        const Real3<Real> nearest = place_at(m, law(k, t));
        const Real least = sqrt(dot(nearest, nearest));
        if (rate(t, slope) > Real(1e-40) || slope <= 0 || t <= 0 || least < 0.05) continue;
        for (const double by : {1e-13, -1e-13}) {
            m.contact_distance = Real(least * (1 + Real(by))).convert_to<double>();
            const Root root = damped_sphere_sphere_root(m, k);
            const bool now = root.kind == RootKind::impact && root.t < t;
            CAPTURE(i, k, by);
            CHECK(now == (by > 0));
            ++(by > 0 ? hits : misses);
        }
    }
    CHECK(hits > 1000);
    CHECK(misses > 1000);
}

TEST_CASE("weak drag gives the times of parabolas")
{
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 r = random.uniform(1.5, 5) * random.direction();
        const AcceleratedMotion m{r, random.in_cube(5) - r, random.in_cube(5), 1};
        const Root plain = sphere_sphere_accelerated_root(m), damped = damped_sphere_sphere_root(m, 1e-18);
        REQUIRE(plain.kind == damped.kind);
        CHECK(damped.t == Approx(plain.t).epsilon(1e-10));
    }
}
