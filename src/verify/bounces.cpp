#include "verify/bounces.hpp"

namespace carom::verification {

namespace {

constexpr int most_bounces = 2'000'000;
constexpr double over = 1e-18;  ///< a bounce so much slower than the first ends a series for every double

}  // namespace

std::optional<InSeries> inside(const SeriesRecord& s, const Vec3& normal, double tau)
{
    InSeries now{Vec3::Zero(), s.velocity, false};
    double speed = s.normal_speed, left = tau;
    for (int i = 0; i < most_bounces; ++i) {
        const double time = 2 * speed / s.gravity;
        if (speed <= over * s.normal_speed) {
            now.ended = true;
            return now;
        }
        if (left < time) {
            now.shift += left * (now.velocity + 0.5 * left * s.acceleration);
            now.shift += left * (speed - 0.5 * s.gravity * left) * normal;
            now.velocity += left * s.acceleration;
            now.velocity += (speed - s.gravity * left) * normal;
            return now;
        }
        now.shift += time * (now.velocity + 0.5 * time * s.acceleration);
        now.velocity = s.tangential * (now.velocity + time * s.acceleration);
        left -= time;
        speed *= s.restitution;
    }
    return {};
}

Swept swept(const Path& path, double radius, const SeriesRecord& s, const Vec3& normal)
{
    const double height = 0.5 * s.normal_speed * (s.normal_speed / s.gravity);
    Swept ball{path, radius + height / 2 * (1 + 8 * u) + 8 * u * (radius + 1)};
    for (int k = 0; k < 3; ++k) {
        ball.path.local[k] += height / 2 * normal[k];
        ball.path.velocity[k] = s.velocity[k];
    }
    ball.path.velocity_low = Vec3::Zero();
    ball.path.acceleration = own_acceleration;
    ball.path.own = s.acceleration;
    if (s.tangential < 1) {
        // Slowed at each bounce it follows no parabola: the ball around all that it can reach.
        const double t = duration(s);
        ball.radius += 1.01 * t * (s.velocity.norm() + 0.5 * t * s.acceleration.norm());
        ball.path.velocity = Vec3::Zero();
        ball.path.own = Vec3::Zero();
    }
    return ball;
}

}  // namespace carom::verification
