#include "adversary/families.hpp"

#include <cmath>

namespace carom::test {

namespace {

/// `a` moves relative to `b`, which is somewhere, moves somehow, and has its share of the radius.
Query pair(Random& random, const Vec3& r, const Vec3& v, double s, double place = 1, double drift = 1)
{
    Query q;
    q.b.position = random.in_cube(place * s);
    q.b.velocity = random.in_cube(drift * v.norm());
    q.a.position = q.b.position + r;
    q.a.velocity = q.b.velocity + v;
    q.a.radius = random.uniform(0.1, 0.9) * s;
    q.b.radius = s - q.a.radius;
    return q;
}

/// At closest approach the centres are `miss` S apart, asked `distance` S before.
Query passing(Random& random, double s, double miss, double distance, double speed, double place = 1, double drift = 1)
{
    const Vec3 n = random.direction(), side = random.across(n);
    return pair(random, s * (miss * side - distance * n), speed * n, s, place, drift);
}

/// With a gap of `gap` S, the normal speed given, and sliding. `b` is at rest in the origin, so that no digit is lost.
Query close(Random& random, double gap, double normal_speed)
{
    const Vec3 n = random.direction(), side = random.across(n);
    const double s = random.uniform(0.5, 2);
    return pair(random, (s * (1 + gap)) * n, normal_speed * n + random.uniform(-1, 1) * side, s, 0, 0);
}

Family grazing(const char* name, double delta)
{
    return {name, [delta](Random& x) {
                const double place = x.coin() ? 0 : 1;
                return passing(x, x.uniform(0.1, 2), 1 + x.uniform(-delta, delta), x.uniform(0.5, 10),
                               x.uniform(0.1, 10), place, place);
            }};
}

Query sized(Random& x, double length, double speed)
{
    const double miss = x.coin() ? x.uniform(0, 1.3) : 1 + x.uniform(-1e-14, 1e-14);
    return passing(x, length * x.uniform(0.1, 2), miss, x.uniform(0.5, 20), speed);
}

/// Integer multiples of the smallest double.
Query subnormal(Random& x)
{
    Query q;
    const auto tiny = [&](int most) { return std::ldexp(x.integer(-most, most), -1074); };
    const auto tiny3 = [&](int most) {
        const double a = tiny(most), b = tiny(most), c = tiny(most);
        return Vec3(a, b, c);
    };
    q.a.position = tiny3(1000);
    q.b.position = tiny3(1000);
    q.a.radius = std::abs(tiny(500)) + 0x1p-1074;
    q.b.radius = std::abs(tiny(500));
    q.a.velocity = x.coin() ? tiny3(100) : x.in_cube(1e-300);
    q.b.velocity = q.a.velocity + (x.coin() ? tiny3(100) : 0.01 * (q.a.position - q.b.position));
    return q;
}

/// Rational rotations: every number an integer, gap and discriminant exactly 0 or of the last digit.
Query lattice(Random& x)
{
    const int a = x.integer(1, 9), b = x.integer(-9, 9), c = x.integer(-9, 9), d = x.integer(-9, 9);
    Eigen::Matrix3d m;
    m << a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c),  //
        2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b),   //
        2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d;
    const double n = a * a + b * b + c * c + d * d, v = x.integer(1, 1000), far = x.integer(6, 1000000);
    const Vec3 cases[6][2] = {{{-far, 3, 4}, {v, 0, 0}},        // passes at exactly S
                              {{-4, 3, 0}, {v, 0, 0}},          // touches and approaches
                              {{-4, 3, 0}, {-v, 0, 0}},         // touches and leaves
                              {{-4, 3, 0}, {3 * v, 4 * v, 0}},  // touches and slides past
                              {{-4 - far, 3, 0}, {v, 0, 0}},   {{-far, 3, 4}, {v, 0, 0}}};
    const int which = x.integer(0, 5);
    Query q;
    const Vec3 at(x.integer(-1000, 1000), x.integer(-1000, 1000), x.integer(-1000, 1000));
    q.b.position = at;
    q.a.position = at + m * cases[which][0];
    q.a.velocity = m * cases[which][1];
    q.a.radius = 2 * n;
    q.b.radius = 3 * n;
    if (which == 5) {  // off by the last digit of one number
        double& last = x.coin() ? q.a.position.y() : x.coin() ? q.a.velocity.z() : q.a.radius;
        last = last == 0 ? x.sign() * 0x1p-60 : std::nextafter(last, x.sign() * 1e300);
    }
    return q;
}

/// One part of a number lies hundreds of digits below another.
Query mixed(Random& x)
{
    const double e = x.log_uniform(1e-150, 1e-20);
    const auto part = [&] { return x.integer(-2, 2) * (x.coin() ? 1 : e); };
    Query q;
    const double px = part(), py = part(), pz = part(), vx = part(), vy = part(), vz = part();
    q.a.position = {px + 1, py, pz};
    q.b.position = {x.coin() ? e : 0, 0, 0};
    q.a.velocity = {vx, vy, vz};
    q.a.radius = x.integer(0, 2);
    q.b.radius = x.coin() ? 1 : e;
    return q;
}

}  // namespace

std::vector<Family> sphere_families()
{
    return {
        {"generic",
         [](Random& x) {
             return passing(x, x.uniform(0.1, 2), x.uniform(0, 2), x.uniform(1.5, 20), x.uniform(0.1, 10));
         }},
        {"head-on", [](Random& x) { return passing(x, 1, 0, x.uniform(1.5, 20), 1, 0, 0); }},
        grazing("grazing 1e-6", 1e-6),
        grazing("grazing 1e-9", 1e-9),
        grazing("grazing 1e-13", 1e-13),
        grazing("grazing 4e-16", 4e-16),
        {"near-parallel",
         [](Random& x) {
             const double miss = x.coin() ? x.uniform(0, 1.3) : 1 + x.uniform(-1e-9, 1e-9);
             return passing(x, 1, miss, x.uniform(1.1, 5), x.log_uniform(1e-12, 1e-6), 1,
                            1 / x.log_uniform(1e-12, 1e-6));
         }},
        {"touching, approaching", [](Random& x) { return close(x, 0, -x.log_uniform(1e-15, 10)); }},
        {"touching, separating", [](Random& x) { return close(x, 0, x.log_uniform(1e-15, 10)); }},
        {"overlapping, approaching",
         [](Random& x) { return close(x, -x.log_uniform(1e-15, 0.9), -x.log_uniform(1e-15, 10)); }},
        {"overlapping, separating",
         [](Random& x) { return close(x, -x.log_uniform(1e-15, 0.9), x.log_uniform(1e-15, 10)); }},
        {"gap 1e-14", [](Random& x) { return close(x, x.uniform(0, 2e-14), x.sign() * x.log_uniform(1e-9, 10)); }},
        {"gap 1e-4", [](Random& x) { return close(x, x.log_uniform(1e-8, 1e-1), -x.log_uniform(1e-6, 10)); }},
        {"approach 1e-12", [](Random& x) { return close(x, x.uniform(-1e-13, 1e-13), x.sign() * 1e-12); }},
        {"speeds 1e-12..1e12",
         [](Random& x) { return passing(x, 1, x.uniform(0, 1.5), x.uniform(1.5, 20), x.log_uniform(1e-12, 1e12)); }},
        {"radius ratio 1e6",
         [](Random& x) {
             Query q = passing(x, 1 + 1e-6, 1 + x.uniform(-2e-6, 2e-6), x.uniform(1.5, 20), 1, 0, 0);
             q.a.radius = 1;
             q.b.radius = 1e-6;
             return q;
         }},
        {"coordinates 1e6",
         [](Random& x) {
             return passing(x, x.uniform(0.1, 2), x.coin() ? x.uniform(0, 2) : 1 + x.uniform(-1e-9, 1e-9),
                            x.uniform(1, 20), 1, 1e6);
         }},
        {"coordinates 1e9",
         [](Random& x) {
             return passing(x, x.uniform(0.1, 2), x.coin() ? x.uniform(0, 2) : 1 + x.uniform(-1e-7, 1e-7),
                            x.uniform(1, 20), 1, 1e9);
         }},
        {"far 1e6..1e10",
         [](Random& x) {
             const double miss = x.coin() ? x.uniform(0, 2) : 1 + x.uniform(-1e-9, 1e-9);
             return passing(x, x.uniform(0.1, 2), miss, x.log_uniform(1e6, 1e10), x.uniform(0.1, 10), 1, 0);
         }},
        {"horizon 1e18",
         [](Random& x) {
             return passing(x, 1, x.uniform(0, 1.3), x.uniform(1e3, 1e5), x.log_uniform(1e-15, 1e-13), 1, 0);
         }},
        {"lengths 1e-160", [](Random& x) { return sized(x, 1e-160, x.coin() ? 1e-160 : 1); }},
        {"lengths 1e150", [](Random& x) { return sized(x, 1e150, x.coin() ? 1e150 : 1); }},
        {"subnormals", subnormal},
        {"lattice", lattice},
        {"mixed exponents", mixed, 2, true},
    };
}

}  // namespace carom::test
