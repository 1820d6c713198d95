#include "adversary/families.hpp"

#include <cmath>

namespace carom::test {

namespace {

Query over(const Vec3& normal, double offset, double radius)
{
    Query q;
    q.plane.emplace();
    q.plane->normal = normal;
    q.plane->offset = offset;
    q.a.radius = radius;
    return q;
}

/// Height h over a plane through about `place`, normal speed w, normal acceleration g, and something sideways.
Query oblique(Random& x, double h, double w, double g, double place = 1)
{
    const Vec3 n = x.direction(), side = x.across(n), at = x.in_cube(place);
    Query q = over(n, n.dot(at), x.uniform(0.1, 1));
    q.a.position = at + (h + q.a.radius) * n;
    q.a.velocity = w * n + x.uniform(-1, 1) * side;
    q.a.acceleration = g * n;
    return q;
}

/// Along an axis every number is what it says.
Query upright(Random& x, double h, double w, double g)
{
    Query q = over({0, 0, 1}, 0, 0.5);
    q.a.position = {x.uniform(-1, 1), x.uniform(-1, 1), h + 0.5};
    q.a.velocity = {x.uniform(-1, 1), 0, w};
    q.a.acceleration = {0, 0, g};
    return q;
}

Query plate(Random& x)
{
    Query q = oblique(x, x.uniform(-6, 6), x.uniform(-3, 3), x.uniform(-3, 3));
    q.plane->thickness = x.coin() ? 0 : x.uniform(0, 0.5);
    return q;
}

/// Sizes of 1e-300 everywhere, the last digits subnormal.
Query subnormal(Random& x)
{
    Query q = oblique(x, x.uniform(-1, 5), x.uniform(-2, 2), x.uniform(-2, 2));
    const double unit = std::ldexp(1, x.integer(-1060, -990));
    for (Vec3* each : {&q.a.position, &q.a.velocity, &q.a.acceleration}) *each *= unit;
    for (double* each : {&q.a.radius, &q.plane->offset}) *each *= unit;
    return q;
}

Query weak(Random& x, double gravity)
{
    const double w = x.integer(-1, 1) * x.log_uniform(1e-3, 1);
    return x.coin() ? oblique(x, x.uniform(0, 5), w, x.sign() * gravity)
                    : upright(x, x.coin() ? 0 : x.uniform(-1, 5), w, x.sign() * gravity);
}

/// Gravity away from the plane; turns at it, nearly.
Query turning(Random& x)
{
    const double w = x.uniform(0.1, 5), g = x.uniform(0.1, 10), h = w * w / (2 * g),
                 off = 1 + x.uniform(-1, 1) * x.log_uniform(1e-16, 1e-6);
    if (x.integer(0, 3) == 0) {  // exactly: 2 g h = w^2 in integers
        const int i = x.integer(1, 1000);
        return upright(x, i, -2 * i, 2 * i);
    }
    return x.coin() ? upright(x, h * off, -w, g) : upright(x, -h * off, w, -g);
}

}  // namespace

std::vector<Family> plane_families()
{
    return {
        {"plane", [](Random& x) { return oblique(x, x.uniform(0, 5), x.uniform(-5, 5), x.uniform(-10, 10)); }},
        {"plane, no gravity", [](Random& x) { return oblique(x, x.uniform(0, 5), x.uniform(-5, 5), 0); }},
        {"plane, from inside",
         [](Random& x) { return upright(x, -x.log_uniform(1e-16, 1), x.uniform(-1, 5), x.uniform(-10, 5)); }},
        {"plane, turning at it", turning},
        {"plane, gravity 1e-300", [](Random& x) { return weak(x, x.log_uniform(1e-306, 1e-290)); }, 4, true},
        {"plane, gravity 1e-30", [](Random& x) { return weak(x, x.log_uniform(1e-60, 1e-10)); }},
        {"plane, resting", [](Random& x) { return upright(x, 0, x.integer(-1, 1) * 0x1p-1074, -x.uniform(0, 10)); }},
        {"plane, just bounced",
         [](Random& x) {
             return upright(x, x.integer(-4, 4) * 0x1p-53, x.log_uniform(1e-12, 10), -x.uniform(0.1, 10));
         }},
        {"plane, coordinates 1e9",
         [](Random& x) { return oblique(x, x.uniform(-1e-7, 5), x.uniform(-5, 5), x.uniform(-10, 10), 1e9); }},
        {"plane, subnormals", subnormal},
        {"plate", plate},
    };
}

}  // namespace carom::test
