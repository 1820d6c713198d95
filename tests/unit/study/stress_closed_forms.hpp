/// \file
/// What the stress scenes expect, in closed form and in extended precision, from the scenes' own numbers.
#pragma once

#include <carom/scene.hpp>

#include <array>
#include <cmath>
#include <limits>

namespace carom::test {

/// A sphere at some time.
struct ExpectedState {
    Vec3 position = Vec3::Zero(), velocity = Vec3::Zero();
};

using Real = long double;

/// Points that stand for two spheres before a wall: the light one at 0 touches it, both at one place touch each other.
struct Shuttle {
    Real light = 0, heavy = 0;              ///< 0 < light < heavy [length]
    Real light_speed = 0, heavy_speed = 0;  ///< away from the wall [length/time]
    std::int64_t impacts = 0;
};

/// Impact by impact, elastic. \param mass of the heavy one in those of the light one \param time how long [time]
inline Shuttle after(Shuttle now, Real mass, Real time)
{
    constexpr std::int64_t most = 10'000'000;
    constexpr Real later = std::numeric_limits<Real>::infinity();
    Real& x = now.light;
    Real& y = now.heavy;
    Real& v = now.light_speed;
    Real& w = now.heavy_speed;
    while (now.impacts < most) {
        const Real to_wall = v < 0 ? -x / v : later, to_heavy = v > w ? (y - x) / (v - w) : later;
        const bool at_wall = to_wall < to_heavy;
        const Real dt = at_wall ? to_wall : to_heavy;
        if (!(dt <= time)) break;
        time -= dt;
        x = at_wall ? 0 : x + v * dt;
        y = at_wall ? y + w * dt : x;  // touching is exact: rounding must not make an impact again
        ++now.impacts;
        if (at_wall) {
            v = -v;
        } else {
            const Real closing = v - w;
            v -= 2 * mass / (mass + 1) * closing;
            w += 2 / (mass + 1) * closing;
        }
    }
    x += v * time;
    y += w * time;
    return now;
}

/// Spheres 0 (light) and 1 (heavy, coming in along x) of a scene at its end, before a wall at x = 0.
struct ShuttleEnd {
    std::array<ExpectedState, 2> states;
    std::int64_t impacts = 0;
};
inline ShuttleEnd shuttle_end(const Scene& scene)
{
    const Sphere &light = scene.spheres[0], &heavy = scene.spheres[1];
    const Real beyond = 2 * Real(light.radius) + Real(heavy.radius);  // of the heavy one's centre when all three touch
    const Shuttle start{Real(light.position.x()) - Real(light.radius), Real(heavy.position.x()) - beyond,
                        light.velocity.x(), heavy.velocity.x(), 0};
    const Shuttle end = after(start, Real(heavy.mass) / Real(light.mass), scene.end_time);
    const auto state = [](Real place, Real speed) {
        return ExpectedState{{static_cast<double>(place), 0, 0}, {static_cast<double>(speed), 0, 0}};
    };
    return {{state(end.light + light.radius, end.light_speed), state(end.heavy + beyond, end.heavy_speed)},
            end.impacts};
}

using Triple = std::array<Real, 3>;

inline Triple wide(const Vec3& a)
{
    return {a[0], a[1], a[2]};
}
inline Vec3 narrow(const Triple& a)
{
    return {static_cast<double>(a[0]), static_cast<double>(a[1]), static_cast<double>(a[2])};
}
/// a + s b
inline Triple plus(const Triple& a, Real s, const Triple& b)
{
    return {a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]};
}
inline Real dot(const Triple& a, const Triple& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Triple cross(const Triple& a, const Triple& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Two spheres that meet once, freely and elastically.
struct Meeting {
    double time = 0;     ///< of the impact [time]
    ExpectedState a, b;  ///< at the end of the scene
};

/// \pre spheres `a` and `b` of the scene meet before its end and nothing else matters to them
inline Meeting meeting(const Scene& scene, std::size_t a, std::size_t b)
{
    const Sphere &sa = scene.spheres[a], &sb = scene.spheres[b];
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
    const auto at_end = [&](const Triple& position, const Triple& before, Real change) {
        const Triple velocity = plus(before, change * closing, at);
        const Triple hit = plus(position, time, before);
        return ExpectedState{narrow(plus(hit, scene.end_time - time, velocity)), narrow(velocity)};
    };
    return {static_cast<double>(time), at_end(pa, va, -2 * mb / (ma + mb)), at_end(pb, vb, 2 * ma / (ma + mb))};
}

/// Height above the floor, at ascending times, of a ball that was dropped and falls for `fall`; bounce by bounce.
class Bouncing {
public:
    Bouncing(double gravity, double fall, double restitution)
        : gravity_(gravity), fall_(fall), e_(restitution), began_(fall), factor_(restitution)
    {
    }

    double height(Real time)
    {
        if (time < fall_) return static_cast<double>(gravity_ / 2 * (fall_ - time) * (fall_ + time));
        constexpr Real nothing = 1e-30L;  // flights shorter than this leave no height
        while (began_ + flight() <= time && flight() > nothing) {
            began_ += flight();
            factor_ *= e_;
        }
        const Real s = time - began_;
        return flight() > nothing && s < flight() ? static_cast<double>(gravity_ / 2 * s * (flight() - s)) : 0;
    }

private:
    Real flight() const { return 2 * fall_ * factor_; }

    Real gravity_, fall_, e_, began_, factor_;
};

/// An elastic sphere in a wedge of planes 0 (level) and 1, seen along y, at the scene's end.
struct WedgeEnd {
    ExpectedState state;
    std::int64_t impacts = 0;
};

/// Mirrored at each wall that it meets, the path is one straight line through copies of the wedge.
/// \pre the centre's edge is at the origin: offsets are -radius; the path passes it anticlockwise or clockwise, not
/// through
inline WedgeEnd wedge_end(const Scene& scene)
{
    const Sphere& sphere = scene.spheres[0];
    const Vec3& upper = scene.planes[1].normal;
    const Real angle = std::atan2(Real(upper.x()), -Real(upper.z()));
    const Real pi = std::acos(Real(-1));
    const Real x = sphere.position.x(), z = sphere.position.z(), vx = sphere.velocity.x(), vz = sphere.velocity.z();
    const Real end_x = x + vx * scene.end_time, end_z = z + vz * scene.end_time;
    const bool anticlockwise = x * vz - z * vx > 0;
    Real end_angle = std::atan2(end_z, end_x);
    if (anticlockwise && end_angle < std::atan2(z, x)) end_angle += 2 * pi;
    if (!anticlockwise && end_angle > std::atan2(z, x)) end_angle -= 2 * pi;
    const Real copy = std::floor(end_angle / angle);
    const bool mirrored = std::fmod(copy, Real(2)) != 0;
    const auto folded = [&](Real a) { return mirrored ? (copy + 1) * angle - a : a - copy * angle; };
    const auto at = [&](Real radius, Real a) {
        return Vec3(static_cast<double>(radius * std::cos(a)), 0, static_cast<double>(radius * std::sin(a)));
    };
    return {{at(std::hypot(end_x, end_z), folded(end_angle)), at(std::hypot(vx, vz), folded(std::atan2(vz, vx)))},
            static_cast<std::int64_t>(std::abs(copy))};
}

/// Velocities after the impact of three spheres that touch in a row along x: e times what elastic impacts of two give,
/// one after the other until nothing closes, and 1 - e times what all have together.
inline std::array<Real, 3> row_of_three(const Scene& scene)
{
    std::array<Real, 3> mass{}, v{};
    Real momentum = 0, total = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        mass[i] = scene.spheres[i].mass;
        v[i] = scene.spheres[i].velocity.x();
        momentum += mass[i] * v[i];
        total += mass[i];
    }
    while (v[0] > v[1] || v[1] > v[2])
        for (std::size_t a = 0; a < 2; ++a) {
            if (!(v[a] > v[a + 1])) continue;
            const Real impulse = 2 * mass[a] * mass[a + 1] / (mass[a] + mass[a + 1]) * (v[a] - v[a + 1]);
            v[a] -= impulse / mass[a];
            v[a + 1] += impulse / mass[a + 1];
        }
    const Real e = scene.materials[static_cast<std::size_t>(scene.spheres[0].material)].restitution;
    for (Real& each : v) each = e * each + (1 - e) * momentum / total;
    return v;
}

/// Way [length] of the upper of two equal spheres from the vertical through their centre of mass, which stays where it
/// is on a smooth floor: d'' = 2 g d / (r_a + r_b) for their distance d along it, as long as d is small.
inline Real leaning_way(const Scene& scene, std::size_t lower, std::size_t upper)
{
    const Sphere &a = scene.spheres[lower], &b = scene.spheres[upper];
    const Real start = Real(b.position.x()) - Real(a.position.x());
    const Real rate = std::sqrt(2 * -Real(scene.gravity.z()) / (Real(a.radius) + Real(b.radius)));
    return start * std::cosh(rate * scene.end_time) / 2;
}

}  // namespace carom::test
