#include "motion/relative.hpp"

#include "flight/damping.hpp"
#include "math/length.hpp"
#include "toi/sphere_sphere.hpp"
#include "toi/sphere_sphere_accelerated.hpp"

#include <cmath>

namespace carom {

namespace {

/// The ball that a sphere occupies or, in a series, sweeps from its start to its end.
struct Swept {
    Vec3 offset = Vec3::Zero();  ///< of its centre from the flight's place [length]
    double radius = 0;
    Vec3 velocity = Vec3::Zero();
    AccelerationId acceleration = Accelerations::none;
};

Swept swept_ball(const State& state, const Moving& m)
{
    const Flight& f = m.flight;
    const double radius = state.radius(m.body);
    if (!m.bouncing) return {Vec3::Zero(), radius, f.velocity, f.acceleration};
    const Series& s = m.bouncing->series;
    const int plane = m.bouncing->plane;
    Swept ball{(s.height() / 2) * facing_normal(state, plane, f.place), radius + s.height() / 2, s.velocity,
               state.bodies.accelerations().along(plane)};
    if (s.tangential < 1) {
        // Slowed at each bounce it follows no parabola: take the ball around all that it can reach.
        ball.radius += slowed_reach(s);
        ball.velocity = Vec3::Zero();
        ball.acceleration = Accelerations::none;
    }
    return ball;
}

}  // namespace

PairMotion pair_motion(const State& state, const Moving& a, const Moving& b)
{
    const Flight &fa = a.flight, &fb = b.flight;
    if (!a.bouncing && !b.bouncing)
        return {relative_motion<double>(state, fa, fb), fa.acceleration, fb.acceleration,
                state.radius(a.body) + state.radius(b.body), false};
    const Swept sa = swept_ball(state, a), sb = swept_ball(state, b);
    PairMotion m;
    m.from = std::max(fa.start, fb.start);
    m.acceleration_a = sa.acceleration;
    m.acceleration_b = sb.acceleration;
    m.contact_distance = sa.radius + sb.radius;
    m.swept = true;

    const Accelerations& accelerations = state.bodies.accelerations();
    const double dt_a = state.frame.between(fa.start, m.from), dt_b = state.frame.between(fb.start, m.from);
    const Vec3 &acc_a = accelerations[sa.acceleration], &acc_b = accelerations[sb.acceleration];
    m.r = separation(state.frame, fa.place, fb.place) +
          ((displacement(sa.velocity, acc_a, dt_a) + sa.offset) - (displacement(sb.velocity, acc_b, dt_b) + sb.offset));
    m.v = (sa.velocity + dt_a * acc_a) - (sb.velocity + dt_b * acc_b);
    return m;
}

PairMotion damped_pair_motion(const State& state, BodyId a, BodyId b)
{
    const Flight &fa = state.flight(a), &fb = state.flight(b);
    PairMotion m;
    m.from = std::max(fa.start, fb.start);
    m.r = separation(state.frame, fa.place, fb.place);
    m.v = fa.velocity - fb.velocity;
    m.acceleration_a = fa.acceleration;
    m.acceleration_b = fb.acceleration;
    m.contact_distance = state.radius(a) + state.radius(b);
    if (fa.start == fb.start) return m;
    const bool a_is_older = fa.start < fb.start;
    const Flight& older = a_is_older ? fa : fb;
    const Vec3& acceleration = state.acceleration(older);
    const Damping<double> d = damping(state.drag, state.frame.between(older.start, m.from));
    const Vec3 way = displacement(older.velocity, acceleration, d),
               velocity = velocity_after(older.velocity, acceleration, d);
    m.r = a_is_older ? Vec3(m.r + way) : Vec3(m.r - way);
    m.v = a_is_older ? Vec3(velocity - fb.velocity) : Vec3(fa.velocity - velocity);
    return m;
}

Root pair_root(const State& state, const PairMotion& m)
{
    if (m.acceleration_a == m.acceleration_b) return sphere_sphere_root(m.r, m.v, m.contact_distance);
    const Accelerations& accelerations = state.bodies.accelerations();
    const Vec3 a = accelerations[m.acceleration_a] - accelerations[m.acceleration_b];
    return sphere_sphere_accelerated_root({m.r, m.v, a, m.contact_distance});
}

bool meet_too_late(const State& state, BodyId a, BodyId b, const PairMotion& m, EpochTime limit)
{
    if (state.bodies.some_in_piece())
        for (const BodyId body : {a, b})
            if (state.bodies.is_in_piece(body))
                limit = std::min(limit, end_of(state.bodies.motion(body), state.frame, state.flight(body).start));
    if (limit == never) return false;
    const double time = std::max(0.0, state.frame.between(m.from, limit));
    const Accelerations& accelerations = state.bodies.accelerations();
    const Vec3 acceleration = accelerations[m.acceleration_a] - accelerations[m.acceleration_b];
    const double way = time * (length(m.v) + time / 2 * length(acceleration));
    const double reach = way_slack * (m.contact_distance + way);
    return m.r.squaredNorm() > reach * reach;
}

PlaneMotion plane_motion(const State& state, const Moving& sphere, int p)
{
    const Flight& f = sphere.flight;
    const Vec3 normal = facing_normal(state, p, f.place);
    PlaneMotion m{height_above(state, sphere.body, p, f.place), normal.dot(f.velocity), 0};
    if (sphere.bouncing) {
        const Swept ball = swept_ball(state, sphere);
        m.h += normal.dot(ball.offset) - (ball.radius - state.radius(sphere.body));
        m.w = normal.dot(ball.velocity);
        m.g = normal.dot(state.bodies.accelerations()[ball.acceleration]);
        return m;
    }
    if (f.acceleration != Accelerations::none) m.g = normal.dot(state.acceleration(f));
    return m;
}

Flight advanced(const State& state, BodyId body, const EpochTime& now)
{
    Flight f = state.flight(body);
    const double dt = state.frame.between(f.start, now);
    f.start = now;
    std::fill_n(f.place.low, 3, 0.0);
    if (const auto* bouncing = state.bodies.as<Bouncing>(body)) {
        const Series& s = bouncing->series;
        const Vec3 normal = facing_normal(state, bouncing->plane, f.place);
        const SeriesState inside = dt < s.duration() ? state_in(s, dt) : state_at_end(s);
        f.place = moved(state.frame, f.place, inside.shift + inside.height * normal);
        f.velocity = inside.velocity + inside.normal_speed * normal;
        f.acceleration = state.bodies.accelerations().free();
        return f;
    }
    const Vec3& a = state.acceleration(f);
    if (state.drag > 0) [[unlikely]] {
        const Damping<double> d = damping(state.drag, dt);
        f.place = moved(state.frame, f.place, displacement(f.velocity, a, d));
        f.velocity = velocity_after(f.velocity, a, d);
        return f;
    }
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
    const Moving own = moving(state, body);
    if (!own.bouncing) return advanced(state, body, now);
    const Swept ball = swept_ball(state, own);
    const Vec3& acceleration = state.bodies.accelerations()[ball.acceleration];
    Flight f = own.flight;
    const double dt = state.frame.between(f.start, now);
    f.start = now;
    f.place = moved(state.frame, f.place, displacement(ball.velocity, acceleration, dt));
    f.velocity = ball.velocity + dt * acceleration;
    f.acceleration = ball.acceleration;
    return f;
}

}  // namespace carom
