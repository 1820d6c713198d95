#include "study/stress/two_spheres.hpp"

#include <array>
#include <cmath>

namespace carom::stress {

namespace {

using Real = long double;
using Triple = std::array<Real, 3>;

Triple wide(const Vec3& a)
{
    return {a[0], a[1], a[2]};
}
Vec3 narrow(const Triple& a)
{
    return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}
/// a + s b
Triple plus(const Triple& a, Real s, const Triple& b)
{
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
Real dot(const Triple& a, const Triple& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Triple cross(const Triple& a, const Triple& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Path {
    Triple position, velocity_before, velocity_after;
};

ExpectedState at_end(BodyId body, const Sphere& sphere, const Path& path, Real time, Real end)
{
    const Triple hit = plus(path.position, time, path.velocity_before);
    ExpectedState state;
    state.body = body;
    state.position = narrow(plus(hit, end - time, path.velocity_after));
    state.velocity = narrow(path.velocity_after);
    state.length = sphere.radius;
    state.speed = state.velocity.norm();
    return state;
}

}  // namespace

Meeting meeting(const Scene& scene, BodyId a, BodyId b)
{
    const Sphere &sa = scene.spheres[static_cast<std::size_t>(a)], &sb = scene.spheres[static_cast<std::size_t>(b)];
    const Triple pa = wide(sa.position), pb = wide(sb.position), va = wide(sa.velocity), vb = wide(sb.velocity);
    const Triple r = plus(pa, -1, pb), v = plus(va, -1, vb);
    const Real speed = std::sqrt(dot(v, v)), contact = Real(sa.radius) + Real(sb.radius);
    // Miss distance, then half the chord as a product: the difference of squares would lose a grazing path.
    const Triple k = cross(r, v);
    const Real miss = std::sqrt(dot(k, k)) / speed;
    const Real half_chord = std::sqrt((contact - miss) * (contact + miss));
    const Real time = (-dot(r, v) / speed - half_chord) / speed;
    const Triple at = plus(r, time, v);
    const Real closing = dot(at, v) / dot(at, at);
    const Real ma = sa.mass, mb = sb.mass;
    const Path path_a{pa, va, plus(va, -2 * mb / (ma + mb) * closing, at)};
    const Path path_b{pb, vb, plus(vb, 2 * ma / (ma + mb) * closing, at)};
    return {static_cast<double>(time), at_end(a, sa, path_a, time, scene.end_time),
            at_end(b, sb, path_b, time, scene.end_time)};
}

void expect_meeting(Trial& trial, BodyId a, BodyId b)
{
    const Meeting expected = meeting(trial.scene, a, b);
    trial.states.push_back(expected.a);
    trial.states.push_back(expected.b);
    trial.impacts = trial.impacts.value_or(0) + 1;
}

ExpectedState free_flight(const Scene& scene, BodyId body)
{
    const Sphere& s = scene.spheres[static_cast<std::size_t>(body)];
    return {body, s.position + scene.end_time * s.velocity, s.velocity, s.radius, s.velocity.norm()};
}

}  // namespace carom::stress
