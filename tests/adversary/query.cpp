#include "adversary/query.hpp"

namespace carom::test {

namespace {

template <class Real>
Real3<Real> difference(const Vec3& a, const Vec3& b)
{
    return {Real(a.x()) - b.x(), Real(a.y()) - b.y(), Real(a.z()) - b.z()};
}

Answer at(ImpactStatus status, Float200 t)
{
    return {status, false, t, 0};
}

/// (-b - sqrt(b^2 - a c)) / a: harmless when every product is exact.
template <class Real>
Answer uniform(const Real3<Real>& r, const Real3<Real>& v, const Real& s)
{
    const Real a = dot(v, v), b = dot(r, v), c = dot(r, r) - s * s;
    if (b >= 0) return {};
    if (c <= 0) return at(ImpactStatus::touching, 0);
    const Real d = b * b - a * c;
    if (d <= 0) return {};
    return at(ImpactStatus::impact, Float200(Real((-b - sqrt(d)) / a)));
}

template <class Real>
Answer over_plane(const MovingSphere& sphere, const Plane& plane)
{
    Real3<Real> n = lift<Real>(plane.normal);
    Real height = dot(n, lift<Real>(sphere.position)) - plane.offset;
    if (plane.thickness) {
        if (height < 0) {
            height = -height;
            for (Real& x : n) x = -x;
        }
        height -= Real(*plane.thickness) / 2;
    }
    const Real h = height - sphere.radius, w = dot(n, lift<Real>(sphere.velocity)),
               g = dot(n, lift<Real>(sphere.acceleration));
    if (h <= 0 && w < 0) return at(ImpactStatus::touching, 0);
    if (h <= 0 && w == 0) return g < 0 ? at(ImpactStatus::touching, 0) : Answer{};
    if (g == 0) return w < 0 ? at(ImpactStatus::impact, Float200(Real(-h / w))) : Answer{};
    const Real d = w * w - 2 * g * h;
    if (g < 0) {
        if (d <= 0) return at(ImpactStatus::impact, Float200(Real(-w / g)));  // turns round inside
        return at(ImpactStatus::impact, Float200(Real((-w - sqrt(d)) / g)));
    }
    if (w >= 0 || d <= 0 || h <= 0) return {};
    return at(ImpactStatus::impact, Float200(Real((-w - sqrt(d)) / g)));
}

}  // namespace

template <class Real>
Answer answer_to(const Query& q)
{
    if (q.plane) return over_plane<Real>(q.a, *q.plane);
    const Real s = Real(q.a.radius) + q.b.radius;
    const auto r = difference<Real>(q.a.position, q.b.position), v = difference<Real>(q.a.velocity, q.b.velocity);
    if (q.is_negligible || q.a.acceleration == q.b.acceleration) return uniform<Real>(r, v, s);
    const auto few = [](const Real3<Real>& x) {
        return Real3<Float200>{Float200(x[0]), Float200(x[1]), Float200(x[2])};
    };
    const auto a = difference<Real>(q.a.acceleration, q.b.acceleration);
    const AcceleratedTruth truth = exact_accelerated(few(r), few(v), few(a), Float200(s));
    const ImpactStatus status = truth.kind == RootKind::none ? ImpactStatus::none
                                : truth.t > 0                ? ImpactStatus::impact
                                                             : ImpactStatus::touching;
    return {status, truth.no_digits, truth.t, 1e-50};
}

template Answer answer_to<Float200>(const Query&);
template Answer answer_to<Float700>(const Query&);

}  // namespace carom::test
