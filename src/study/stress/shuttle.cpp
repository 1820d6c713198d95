#include "study/stress/shuttle.hpp"

#include <limits>

namespace carom::stress {

namespace {

using Real = long double;

ExpectedState state(BodyId body, Real place, Real speed, double radius)
{
    const Vec3 velocity(static_cast<double>(speed), 0, 0);
    return {body, {static_cast<double>(place), 0, 0}, velocity, radius, velocity.norm()};
}

}  // namespace

Shuttle after(Shuttle now, Real mass, Real time)
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

void expect_shuttle(Trial& trial)
{
    const Sphere &light = trial.scene.spheres[0], &heavy = trial.scene.spheres[1];
    const Real beyond = 2 * Real(light.radius) + Real(heavy.radius);  // of the heavy one's centre when all three touch
    const Shuttle start{Real(light.position.x()) - Real(light.radius), Real(heavy.position.x()) - beyond,
                        light.velocity.x(), heavy.velocity.x(), 0};
    const Shuttle end = after(start, Real(heavy.mass) / Real(light.mass), trial.scene.end_time);
    trial.states = {state(0, end.light + light.radius, end.light_speed, light.radius),
                    state(1, end.heavy + beyond, end.heavy_speed, heavy.radius)};
    trial.impacts = end.impacts;
}

}  // namespace carom::stress
