#include "adversary/families.hpp"

#include <cmath>

namespace carom::test {

namespace {

Query pair(Random& random, const Vec3& r, const Vec3& v, const Vec3& a, double s, double place = 0)
{
    Query q;
    q.b.position = random.in_cube(place);
    q.a.position = q.b.position + r;
    q.a.velocity = v;
    q.a.acceleration = a;
    q.a.radius = random.uniform(0.1, 0.9) * s;
    q.b.radius = s - q.a.radius;
    return q;
}

/// At contact at t, at the relative velocity w, and back from there.
Query backwards(Random& x, double t, const Vec3& w, double gap)
{
    const Vec3 n = x.direction(), a = x.in_cube(3);
    const double s = x.uniform(0.5, 2);
    const Vec3 contact = s * (1 + gap) * n, side = x.across(n);
    const Vec3 v = w.x() * n + w.y() * side;
    return pair(x, contact - t * v + (0.5 * t * t) * a, v - t * a, a, s, x.coin() ? 0 : 1);
}

/// Touching or overlapping by rounding, thrown up, coming back.
Query return_of(Random& x, double gap)
{
    const Vec3 n = x.direction();
    const double s = x.uniform(0.5, 2);
    return pair(x, s * (1 + gap) * n, x.log_uniform(1e-9, 10) * n + (x.coin() ? 0.01 : 0.0) * x.across(n), -9.81 * n,
                s);
}

/// Exactly solvable: along a line, in integers.
Query integers(Random& x)
{
    const double s = x.integer(1, 5), h = x.integer(-1, 8), v = x.integer(-6, 6), a = x.integer(0, 1) ? -2 : 2;
    Query q;
    q.a.position = {0, 0, s + h};
    q.a.velocity = {x.integer(0, 3) == 0 ? 1.0 : 0.0, 0, v};
    q.a.acceleration = {0, 0, a};
    q.b.radius = s;
    return q;
}

}  // namespace

std::vector<Family> accelerated_families()
{
    constexpr int few = 1;
    return {
        {"accelerated",
         [](Random& x) {
             return backwards(x, x.uniform(0.1, 3), {x.uniform(-5, 1), x.uniform(-2, 2), 0}, 0);
         },
         few},
        {"accelerated, grazing",
         [](Random& x) {
             return backwards(x, x.uniform(0.1, 3), {x.sign() * x.log_uniform(1e-17, 1e-3), x.uniform(0.5, 2), 0},
                              x.uniform(-1, 1) * x.log_uniform(1e-17, 1e-6));
         },
         few},
        {"accelerated, comes back", [](Random& x) { return return_of(x, x.uniform(-4e-15, 4e-15)); }, few},
        {"accelerated, from inside", [](Random& x) { return return_of(x, -x.log_uniform(1e-9, 0.5)); }, few},
        {"accelerated, integers", integers, few},
        {"accelerated, far",
         [](Random& x) {
             const Vec3 n = x.direction();
             return pair(x, 1e6 * n, -1e3 * n + x.in_cube(1e-4), -9.81 * n, x.uniform(0.5, 2));
         },
         few},
        {"accelerated by 1e-200",
         [](Random& x) {
             const Vec3 n = x.direction(), side = x.across(n);
             Query q = pair(x, x.uniform(3, 10) * n + x.uniform(-0.4, 0.4) * side, -x.uniform(1, 3) * n,
                            x.log_uniform(1e-200, 1e-150) * x.direction(), x.uniform(0.5, 2));
             q.is_negligible = true;
             return q;
         },
         few},
    };
}

}  // namespace carom::test
