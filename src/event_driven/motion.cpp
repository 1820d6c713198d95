#include "event_driven/motion.hpp"

#include "math/double_double.hpp"
#include "math/length.hpp"
#include "toi/sphere_plane.hpp"
#include "toi/sphere_sphere.hpp"
#include "toi/sphere_sphere_accelerated.hpp"

#include <cmath>

namespace carom {

namespace {

/// The ball that a sphere occupies or, in a series, sweeps from its start to its end.
struct Swept {
    Vec3 offset = Vec3::Zero();  ///< of its centre from the flight's place [length]
    double radius;
    Vec3 velocity;
    AccelerationId acceleration;
};

Swept swept_ball(const State& state, const Moving& m)
{
    const Flight& f = m.flight;
    const double radius = state.radius(m.body);
    if (f.mode != Mode::series) return {Vec3::Zero(), radius, f.velocity, f.acceleration};
    const Series& s = *m.series;
    Swept ball{(s.height() / 2) * facing_normal(state, f.support, f.place), radius + s.height() / 2, s.velocity,
               state.accelerations.along(f.support)};
    if (s.tangential < 1) {
        // Slowed at each bounce it follows no parabola: take the ball around all that it can reach.
        ball.radius += slowed_reach(s);
        ball.velocity = Vec3::Zero();
        ball.acceleration = Accelerations::none;
    }
    return ball;
}

}  // namespace

namespace {

/// Neither sphere is in a series. Only the older flight has moved since it began.
PairMotion plain_pair_motion(const State& state, const Moving& a, const Moving& b)
{
    const Flight &fa = a.flight, &fb = b.flight;
    PairMotion m{.from = fa.start,
                 .r = {},
                 .v = fa.velocity - fb.velocity,
                 .acceleration_a = fa.acceleration,
                 .acceleration_b = fb.acceleration,
                 .contact_distance = state.radius(a.body) + state.radius(b.body),
                 .swept = false};
    m.r = separation(state.frame, fa.place, fb.place);
    if (fa.start == fb.start) return m;
    const bool a_is_older = fa.start < fb.start;
    const Flight &older = a_is_older ? fa : fb, &newer = a_is_older ? fb : fa;
    m.from = newer.start;
    const double dt = state.frame.between(older.start, newer.start);
    Vec3 shift = dt * older.velocity;
    if (older.acceleration != Accelerations::none) {
        const Vec3& acceleration = state.accelerations[older.acceleration];
        shift = displacement(older.velocity, acceleration, dt);
        const Vec3 velocity = older.velocity + dt * acceleration;
        m.v = a_is_older ? Vec3(velocity - newer.velocity) : Vec3(newer.velocity - velocity);
    }
    if (a_is_older)
        m.r += shift;
    else
        m.r -= shift;
    return m;
}

}  // namespace

PairMotion pair_motion(const State& state, const Moving& a, const Moving& b)
{
    const Flight &fa = a.flight, &fb = b.flight;
    if (fa.mode != Mode::series && fb.mode != Mode::series) return plain_pair_motion(state, a, b);
    const Swept sa = swept_ball(state, a), sb = swept_ball(state, b);
    PairMotion m;
    m.from = std::max(fa.start, fb.start);
    m.acceleration_a = sa.acceleration;
    m.acceleration_b = sb.acceleration;
    m.contact_distance = sa.radius + sb.radius;
    m.swept = true;

    const double dt_a = state.frame.between(fa.start, m.from), dt_b = state.frame.between(fb.start, m.from);
    const Vec3 &acc_a = state.accelerations[sa.acceleration], &acc_b = state.accelerations[sb.acceleration];
    m.r = separation(state.frame, fa.place, fb.place) +
          ((displacement(sa.velocity, acc_a, dt_a) + sa.offset) - (displacement(sb.velocity, acc_b, dt_b) + sb.offset));
    m.v = (sa.velocity + dt_a * acc_a) - (sb.velocity + dt_b * acc_b);
    return m;
}

Root pair_root(const State& state, const PairMotion& m)
{
    if (m.acceleration_a == m.acceleration_b) return sphere_sphere_root(m.r, m.v, m.contact_distance);
    const Vec3 a = state.accelerations[m.acceleration_a] - state.accelerations[m.acceleration_b];
    return sphere_sphere_accelerated_root({m.r, m.v, a, m.contact_distance});
}

bool meet_too_late(const State& state, BodyId a, BodyId b, const PairMotion& m, EpochTime limit)
{
    for (const BodyId body : {a, b})
        if (state.flight(body).mode == Mode::numeric) limit = std::min(limit, state.pieces.at(body).end);
    if (limit == never) return false;
    const double time = std::max(0.0, state.frame.between(m.from, limit));
    const Vec3 acceleration = state.accelerations[m.acceleration_a] - state.accelerations[m.acceleration_b];
    const double way = time * (length(m.v) + time / 2 * length(acceleration));
    constexpr double rounding = 1 + 1e-9;
    const double reach = rounding * (m.contact_distance + way);
    return m.r.squaredNorm() > reach * reach;
}

PlaneMotion plane_motion(const State& state, const Moving& sphere, int p)
{
    const Flight& f = sphere.flight;
    const Vec3 normal = facing_normal(state, p, f.place);
    PlaneMotion m{height_above(state, sphere.body, p, f.place), normal.dot(f.velocity), 0};
    if (f.mode == Mode::series) {
        const Swept ball = swept_ball(state, sphere);
        m.h += normal.dot(ball.offset) - (ball.radius - state.radius(sphere.body));
        m.w = normal.dot(ball.velocity);
        m.g = normal.dot(state.accelerations[ball.acceleration]);
        return m;
    }
    if (f.acceleration != Accelerations::none) m.g = normal.dot(state.accelerations[f.acceleration]);
    return m;
}

Flight advanced(const State& state, BodyId body, const EpochTime& now)
{
    Flight f = state.flight(body);
    const double dt = state.frame.between(f.start, now);
    f.start = now;
    if (f.mode == Mode::series) {
        const Series& s = state.series.at(body);
        const Vec3 normal = facing_normal(state, f.support, f.place);
        const SeriesState inside = dt < s.duration() ? state_in(s, dt) : state_at_end(s);
        f.place = moved(state.frame, f.place, inside.shift + inside.height * normal);
        f.velocity = inside.velocity + inside.normal_speed * normal;
        f.acceleration = state.accelerations.free();
        f.support = -1;
        f.mode = Mode::flying;
        return f;
    }
    const Vec3& a = state.accelerations[f.acceleration];
    f.place = moved(state.frame, f.place, displacement(f.velocity, a, dt));
    f.velocity += dt * a;
    return f;
}

double slowed_reach(const Series& s)
{
    if (!(s.tangential < 1)) return 0;
    return s.duration() *
           (std::sqrt(s.velocity.squaredNorm()) + 0.5 * s.duration() * std::sqrt(s.acceleration.squaredNorm()));
}

Flight filed_path(const State& state, BodyId body, const EpochTime& now)
{
    if (state.flight(body).mode != Mode::series) return advanced(state, body, now);
    const Swept ball = swept_ball(state, moving(state, body));
    Flight f = state.flight(body);
    const double dt = state.frame.between(f.start, now);
    f.start = now;
    f.place = moved(state.frame, f.place, displacement(ball.velocity, state.accelerations[ball.acceleration], dt));
    f.velocity = ball.velocity + dt * state.accelerations[ball.acceleration];
    f.acceleration = ball.acceleration;
    return f;
}

}  // namespace carom
