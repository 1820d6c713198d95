#include "toi/scene_plane.hpp"

#include "toi/scaling.hpp"
#include "toi/tolerances.hpp"

namespace carom {

namespace {

/// n.x less some numbers.
Bounded bounded_dot(const Vec3& n, const Vec3& x, const double* less, int count)
{
    DoubleDouble sum;
    double terms = 0;
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble product = two_product(n[k], x[k]);
        sum = sum + product;
        terms += std::abs(product.high);
    }
    for (int k = 0; k < count; ++k) {
        sum = sum - DoubleDouble(less[k]);
        terms += std::abs(less[k]);
    }
    if (terms == 0 && n.cwiseProduct(x).isZero(0) && (n.isZero(0) || x.isZero(0))) return {sum, 0};
    return {sum, plane_dot_rounding * terms + plane_underflow};
}

Dyadic exact_dot(const Vec3& n, const Vec3& x)
{
    return dot(exact(exactly(n)), exact(exactly(x)));
}

}  // namespace

Bounded ScenePlane::bounded_height() const
{
    return bounded_dot(normal, position, &offset, 1);
}
Dyadic ScenePlane::height() const
{
    return exact_dot(normal, position) - Dyadic(offset);
}

Bounded ScenePlane::bounded_h() const
{
    const double less[3] = {offset, half_thickness, radius};
    return bounded_dot(normal, position, less, 3);
}
Bounded ScenePlane::bounded_w() const
{
    return bounded_dot(normal, velocity, nullptr, 0);
}
Bounded ScenePlane::bounded_g() const
{
    return bounded_dot(normal, acceleration, nullptr, 0);
}
Dyadic ScenePlane::h() const
{
    return height() - Dyadic(half_thickness) - Dyadic(radius);
}
Dyadic ScenePlane::w() const
{
    return exact_dot(normal, velocity);
}
Dyadic ScenePlane::g() const
{
    return exact_dot(normal, acceleration);
}

}  // namespace carom
