/// What is meant is made first, in 200 digits; the kernel is told a rounding of it and how far that may be off.
#include "toi/enclosure.hpp"

#include "support/random.hpp"
#include "unit/toi/oracle.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace carom;
using carom::test::Float200;
using carom::test::Random;
using carom::test::Real3;

namespace {

struct Meant {
    Real3<Float200> r, v;
    Float200 s;
};

struct Oracle {
    bool impact = false;
    Float200 t = 0;
};

Oracle solve(const Meant& m)
{
    const Float200 a = test::dot(m.v, m.v), b = test::dot(m.r, m.v), c = test::dot(m.r, m.r) - m.s * m.s,
                   d = b * b - a * c;
    if (b >= 0) return {};
    if (c <= 0) return {true, 0};
    if (d <= 0) return {};
    return {true, Float200(c / (sqrt(d) - b))};
}

Float200 lift(double x)
{
    return x;
}
Float200 lift(DoubleDouble x)
{
    return Float200(x.high) + x.low;
}

struct Tally {
    int impacts = 0, none = 0, ambiguous = 0;
    double widest = 0;  ///< of certain impacts, relative
    double used = 0;    ///< largest share of the half width that the error took
};

template <class Number>
void judge(const Enclosure<Number>& answer, const Oracle& truth, Tally& tally)
{
    CAPTURE(static_cast<int>(answer.decided), Float200(lift(answer.t)).str(20), truth.t.convert_to<double>(),
            truth.impact);
    if (answer.decided == Decision::ambiguous) {
        ++tally.ambiguous;
        if (truth.impact) REQUIRE((lift(answer.t_lo) <= truth.t && truth.t <= lift(answer.t_hi)));
        return;
    }
    REQUIRE(truth.impact == (answer.decided == Decision::impact));
    (truth.impact ? tally.impacts : tally.none)++;
    if (!truth.impact) return;
    REQUIRE((lift(answer.t_lo) <= truth.t && truth.t <= lift(answer.t_hi)));
    REQUIRE((lift(answer.t_lo) <= lift(answer.t) && lift(answer.t) <= lift(answer.t_hi)));
    if (truth.t == 0) return;
    const Float200 off = truth.t - lift(answer.t);
    const Float200 room =
        off < 0 ? Float200(lift(answer.t) - lift(answer.t_lo)) : Float200(lift(answer.t_hi) - lift(answer.t));
    tally.used = std::max(tally.used, static_cast<double>(Float200(abs(off) / room)));
    tally.widest =
        std::max(tally.widest, static_cast<double>(Float200((lift(answer.t_hi) - lift(answer.t_lo)) / truth.t)));
}

DoubleDouble to_double_double(const Float200& x)
{
    const double high = x.convert_to<double>();
    return {high, Float200(x - high).convert_to<double>()};
}

/// Passing at `miss` S, from a distance of `distance` S; every number has far more digits than a double.
Meant passing(Random& random, double s, double miss, double distance, double speed)
{
    const Vec3 n = random.direction(), side = random.across(n);
    const auto more = [&](double x) { return Float200(x) * (1 + Float200(random.uniform(-1, 1)) * 1e-17); };
    Meant m;
    m.s = more(s);
    for (int k = 0; k < 3; ++k) {
        m.r[k] = more(s * (miss * side[k] - distance * n[k]));
        m.v[k] = more(speed * n[k]);
    }
    return m;
}

Meant random_case(Random& random, int family)
{
    const double s = random.uniform(0.1, 2);
    switch (family) {
        case 0:
            return passing(random, s, random.uniform(0, 2), random.uniform(1.5, 20), random.uniform(0.1, 10));
        case 1:
            return passing(random, s, 1 + random.sign() * random.log_uniform(1e-30, 1e-3), random.uniform(0.5, 9), 1);
        case 2:
            return passing(random, s, random.uniform(0, 0.9), random.log_uniform(1e4, 1e10), 1);
        case 3:
            return passing(random, s, 0, 1 + random.sign() * random.log_uniform(1e-30, 1e-3), random.sign());
        case 4:
            return passing(random, s * 1e-170, random.uniform(0, 1.2), random.uniform(1.5, 20), 1e110);
        default: {  // almost touching, sliding past
            Meant m = passing(random, s, 1 + random.sign() * random.log_uniform(1e-30, 1e-3), 0, 1);
            const Float200 slope = random.sign() * random.log_uniform(1e-30, 1e-3);
            for (int k = 0; k < 3; ++k) m.v[k] += slope * m.r[k];
            return m;
        }
    }
}
constexpr int families = 6;

/// The kernel is told something up to `error` (relative to the largest component) beside what is meant.
template <class Number>
Number told(Random& random, const Float200& meant, double error)
{
    const Float200 x = meant + Float200(random.uniform(-1, 1)) * error;
    if constexpr (std::is_same_v<Number, double>)
        return x.convert_to<double>();
    else
        return to_double_double(x);
}

double largest(const Real3<Float200>& a)
{
    Float200 most = 0;
    for (const Float200& x : a) most = std::max(most, Float200(abs(x)));
    return most.convert_to<double>();
}

}  // namespace

TEST_CASE("in double the certified answer holds for what is meant, and the interval contains its time", "[enclosure]")
{
    Random random(1);
    for (const double relative : {0.0, 1e-15, 1e-9, 1e-3}) {
        Tally tally;
        for (int i = 0; i < 12000; ++i) {
            const Meant m = random_case(random, i % families);
            const SphereInputError e{relative * largest(m.r), relative * largest(m.v),
                                     relative * m.s.convert_to<double>()};
            const double x = told<double>(random, m.r[0], e.r), y = told<double>(random, m.r[1], e.r),
                         z = told<double>(random, m.r[2], e.r);
            const double vx = told<double>(random, m.v[0], e.v), vy = told<double>(random, m.v[1], e.v),
                         vz = told<double>(random, m.v[2], e.v);
            judge(enclose(Vec3(x, y, z), Vec3(vx, vy, vz), told<double>(random, m.s, e.s), e), solve(m), tally);
        }
        INFO("relative " << relative << ": " << tally.impacts << " impacts, " << tally.none << " none, "
                         << tally.ambiguous << " ambiguous, used " << tally.used);
        CHECK(tally.impacts > 2000);
        CHECK(tally.none > (relative > 1e-4 ? 1000 : 2000));
        CHECK(tally.ambiguous < (relative < 1e-8 ? 5000 : 8000));
        CHECK(tally.used <= 1);
    }
}

TEST_CASE("in double-double the certified answer holds, to within the errors that went in", "[enclosure]")
{
    Random random(2);
    for (const double relative : {0x1p-100, 1e-25, 1e-9}) {
        Tally tally;
        for (int i = 0; i < 12000; ++i) {
            const Meant m = random_case(random, i % families);
            const SphereInputError e{relative * largest(m.r), relative * largest(m.v),
                                     relative * m.s.convert_to<double>()};
            const auto tell = [&](const Float200& x, double error) {
                return told<DoubleDouble>(random, x, error * 0.9);
            };
            const DoubleDouble x = tell(m.r[0], e.r), y = tell(m.r[1], e.r), z = tell(m.r[2], e.r);
            const DoubleDouble vx = tell(m.v[0], e.v), vy = tell(m.v[1], e.v), vz = tell(m.v[2], e.v);
            judge(enclose(DoubleDouble3{x, y, z}, DoubleDouble3{vx, vy, vz}, tell(m.s, e.s), e), solve(m), tally);
        }
        INFO("relative " << relative << ": " << tally.impacts << " impacts, " << tally.none << " none, "
                         << tally.ambiguous << " ambiguous, used " << tally.used);
        CHECK(tally.impacts > 3000);
        CHECK(tally.none > 2500);
        CHECK(tally.ambiguous < (relative < 1e-20 ? 100 : 4500));
        CHECK(tally.used <= 1);
    }
}

TEST_CASE("double-doubles taken exactly are never ambiguous, and their time is within 2^-70", "[enclosure]")
{
    Random random(3);
    Tally tally;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        Meant m = random_case(random, i % families);
        const DoubleDouble3 r{to_double_double(m.r[0]), to_double_double(m.r[1]), to_double_double(m.r[2])},
            v{to_double_double(m.v[0]), to_double_double(m.v[1]), to_double_double(m.v[2])};
        const DoubleDouble s = to_double_double(m.s);
        m = {{lift(r.x), lift(r.y), lift(r.z)}, {lift(v.x), lift(v.y), lift(v.z)}, lift(s)};
        const Oracle truth = solve(m);
        const auto answer = enclose(r, v, s);
        judge(answer, truth, tally);
        if (truth.impact && truth.t > 0)
            worst = std::max(worst, static_cast<double>(Float200(abs(lift(answer.t) - truth.t) / truth.t)));
    }
    CHECK(tally.ambiguous == 0);
    CHECK(worst < 0x1p-70);
    CHECK(tally.widest < 0x1p-68);
    CHECK(tally.used <= 1);
}

namespace {

struct PlaneMeant {
    Float200 h, w, g;
};

struct PlaneOracle {
    Decision decided = Decision::none;
    Float200 t = 0;
};

PlaneOracle solve(const PlaneMeant& m)
{
    const Float200 d = m.w * m.w - 2 * m.g * m.h;
    if (m.h <= 0) {
        if (m.w < 0) return {Decision::impact, 0};
        if (m.g >= 0) return {};
        if (m.w == 0) return {Decision::pressed, 0};
        return {Decision::impact, Float200(d <= 0 ? Float200(m.w / -m.g) : Float200((m.w + sqrt(d)) / -m.g))};
    }
    if (m.g < 0)
        return {Decision::impact,
                Float200(m.w > 0 ? Float200((m.w + sqrt(d)) / -m.g) : Float200(2 * m.h / (sqrt(d) - m.w)))};
    if (m.w >= 0 || d <= 0) return {};
    return {Decision::impact, Float200(2 * m.h / (sqrt(d) - m.w))};
}

PlaneMeant plane_case(Random& random, int family)
{
    const auto number = [&](double low, double high) {
        return Float200(random.log_uniform(low, high)) * (1 + Float200(random.uniform(-1, 1)) * 1e-17);
    };
    const double up = random.sign(), side = random.sign();
    switch (family) {
        case 0:
            return {number(0.1, 10), up * number(0.1, 10), side * number(0.1, 10)};
        case 1: {  // turns at the plane, or nearly
            const Float200 w = number(0.1, 10), g = number(0.1, 10);
            const Float200 h = w * w / (2 * g) * (1 + side * number(1e-30, 1e-6));
            return up > 0 ? PlaneMeant{h, -w, g} : PlaneMeant{-h, w, -g};
        }
        case 2:
            return {side * number(1e-30, 1e-10), up * number(0.1, 10), -number(0.1, 10)};  // just bounced
        case 3:
            return {number(0.1, 10), up * number(1e-30, 1e-10), side * number(0.1, 10)};
        case 4:
            return {side * number(1e-160, 1e-150), up * number(1e-90, 1e-80), -number(1e-30, 1e-20)};
        case 5:
            return {number(0.1, 10), up * number(0.1, 10), -number(1e-260, 1e-250)};
        default:
            return {-number(0.1, 10), number(0.1, 10), side * number(0.1, 10)};
    }
}
constexpr int plane_families = 7;

template <class Number>
Tally run_planes(Random& random, double relative)
{
    Tally tally;
    for (int i = 0; i < 14000; ++i) {
        PlaneMeant m = plane_case(random, i % plane_families);
        const auto error = [&](const Float200& x) { return relative * std::abs(x.convert_to<double>()); };
        // A height is a difference of larger numbers: its error does not know how small it is.
        const PlaneInputError e{i % plane_families == 2 ? relative : error(m.h), error(m.w), error(m.g)};
        const auto tell = [&](const Float200& x, double most) { return told<Number>(random, x, 0.9 * most); };
        const Number h = tell(m.h, e.h), w = tell(m.w, e.w), g = tell(m.g, e.g);
        if (relative == 0) m = {lift(h), lift(w), lift(g)};
        const PlaneOracle truth = solve(m);
        const Enclosure<Number> answer = enclose_plane(h, w, g, e);
        if (answer.decided != Decision::ambiguous) REQUIRE(truth.decided == answer.decided);
        judge(answer, Oracle{truth.decided == Decision::impact, truth.t}, tally);
    }
    return tally;
}

}  // namespace

TEST_CASE("for planes the certified answer holds for what is meant, in double and double-double", "[enclosure]")
{
    Random random(4);
    for (const double relative : {1e-9, 1e-14, 4e-16}) {
        const Tally tally = run_planes<double>(random, relative);
        INFO("relative " << relative << ": " << tally.impacts << " impacts, " << tally.none << " none, "
                         << tally.ambiguous << " ambiguous, used " << tally.used);
        CHECK(tally.impacts > 7000);
        CHECK(tally.none > 1000);
        CHECK(tally.ambiguous < 2000);
        CHECK(tally.used <= 1);
    }
    for (const double relative : {1e-9, 0x1p-100}) {
        const Tally tally = run_planes<DoubleDouble>(random, relative);
        INFO("relative " << relative << ": " << tally.impacts << " impacts, " << tally.none << " none, "
                         << tally.ambiguous << " ambiguous, used " << tally.used);
        CHECK(tally.impacts > 7000);
        CHECK(tally.none > 1000);
        CHECK(tally.ambiguous < 2000);
        CHECK(tally.used <= 1);
    }
}

TEST_CASE("heights, rates and accelerations taken exactly are never ambiguous in double-double", "[enclosure]")
{
    Random random(5);
    const Tally tally = run_planes<DoubleDouble>(random, 0);
    CHECK(tally.ambiguous == 0);
    CHECK(tally.widest < 0x1p-68);
    CHECK(tally.used <= 1);
    CHECK(enclose_plane(DoubleDouble(0), DoubleDouble(0), DoubleDouble(-1)).decided == Decision::pressed);
    CHECK(enclose_plane(DoubleDouble(0), DoubleDouble(0), DoubleDouble(0)).decided == Decision::none);
    CHECK(enclose_plane(DoubleDouble(2), DoubleDouble(-2), DoubleDouble(1)).decided == Decision::none);  // grazes
    const auto bounced = enclose_plane(DoubleDouble(0), DoubleDouble(3), DoubleDouble(-2));
    CHECK(bounced.decided == Decision::impact);
    CHECK(bounced.t.high == 3);
}
