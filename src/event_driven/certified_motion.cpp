#include "event_driven/certified_motion.hpp"

#include "event_driven/certified_pair.hpp"
#include "event_driven/certified_plane.hpp"

namespace carom {

namespace {

constexpr double u = unit_roundoff;

ContactTime contact_time(const Frame& frame, const EpochTime& from, const Enclosure<DoubleDouble>& e)
{
    if (e.decided == Decision::none) return {};
    if (e.decided == Decision::pressed) return {true, from};
    return {true, rough_time(frame, from, e.t_lo.high)};
}

/// Half of all pairs end here.
bool certainly_separating(const Vec3& r, const Vec3& v, const SphereInputError& error)
{
    const double p1 = r.x() * v.x(), p2 = r.y() * v.y(), p3 = r.z() * v.z();
    const double rs = std::abs(r.x()) + std::abs(r.y()) + std::abs(r.z()),
                 vs = std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z());
    const double bound = 8 * u * (std::abs(p1) + std::abs(p2) + std::abs(p3)) + 2 * (error.v * rs + error.r * vs) +
                         4 * error.r * error.v;
    // Neither overflow nor underflow passes for certain.
    constexpr double least = 0x1p-900;
    return p1 + p2 + p3 > bound && bound > least;
}

/// No speed towards a plane that is no plate, and no acceleration: most walls, most of the time.
bool certainly_receding(const State& state, const Flight& f, int p)
{
    const Plane& plane = state.plane(p);
    if (plane.thickness || !(plane.normal.dot(f.velocity) > 8 * u * largest(f.velocity))) return false;
    if (f.acceleration == Accelerations::none) return true;
    const Vec3& g = state.accelerations[f.acceleration];
    bool across = true;  // gravity along the plane, to the last bit
    for (int k = 0; k < 3; ++k) across = across && (plane.normal[k] == 0 || g[k] == 0);
    return across || plane.normal.dot(g) > 8 * u * largest(g);
}

/// C = r.r - S^2 with its bound.
Bounded squared_gap(const DoubleDouble3& r, DoubleDouble s)
{
    const DoubleDouble r2 = dot(r, r), s2 = s * s;
    return {r2 - s2, dd_error * (r2.high + s2.high)};
}

template <class Depth>
EpochTime outside(const Frame& frame, const EpochTime& from, EpochTime time, const Depth& overlap_at)
{
    // Places are rounded, and may lie on the wrong side of a contact by 2^-100 or so.
    constexpr int most_steps = 8;
    for (int i = 0; i < most_steps && from < time && time != never && overlap_at(time) > 0; ++i)
        time = step_back(frame, from, time);
    return time;
}

}  // namespace

ContactTime rough_pair_time(const State& state, BodyId a, BodyId b)
{
    const PairMotion m = pair_motion(state, moving(state, a), moving(state, b));
    const Flight &fa = state.flight(a), &fb = state.flight(b);
    const Flight& older = fa.start < fb.start ? fa : fb;
    const double dt = state.frame.between(older.start, m.from);
    const double g = largest(state.accelerations[older.acceleration]), speed = largest(older.velocity) + dt * g;
    const double dt_error = 3 * u * dt + 2 * u * state.frame.epoch_length;
    SphereInputError error;
    error.r = 6 * u * (largest(m.r) + state.frame.cell_size + dt * speed) + dt_error * speed;
    error.v = 4 * u * (largest(m.v) + speed) + dt_error * g;
    if (certainly_separating(m.r, m.v, error)) return {};
    const Enclosure<double> quick = enclose(m.r, m.v, m.contact_distance, error);
    if (quick.decided == Decision::none) return {};
    if (quick.decided == Decision::impact) return {true, rough_time(state.frame, m.from, quick.t_lo)};
    const PairFromLaterStart pair(state, a, b);
    return contact_time(state.frame, pair.from, pair.enclose());
}

ContactTime rough_plane_time(const State& state, BodyId body, int p)
{
    const Flight& f = state.flight(body);
    if (certainly_receding(state, f, p)) return {};
    const PlaneMotion m = plane_motion(state, moving(state, body), p);
    const double g = largest(state.accelerations[f.acceleration]);
    const PlaneInputError error{8 * u * (std::abs(m.h) + state.frame.cell_size), 8 * u * largest(f.velocity),
                                8 * u * g};
    const Enclosure<double> quick = enclose_plane(m.h, m.w, m.g, error);
    if (quick.decided == Decision::none) return {};
    if (quick.decided == Decision::impact) return {true, rough_time(state.frame, f.start, quick.t_lo)};
    const Flown start = at_start(state, body);
    return contact_time(state.frame, f.start, PlaneQuery(state, start, body, p).enclose());
}

EpochTime pair_time(const State& state, BodyId a, BodyId b)
{
    const PairFromLaterStart pair(state, a, b);
    const EpochTime time = no_later(state.frame, pair.from, pair.enclose().t_lo);
    return outside(state.frame, pair.from, time, [&](const EpochTime& t) {
        return certified_penetration(state, flown(state, a, t), a, flown(state, b, t), b);
    });
}

EpochTime plane_time(const State& state, BodyId body, int p)
{
    const Flown start = at_start(state, body);
    const EpochTime& from = start.flight.start;
    const EpochTime time = no_later(state.frame, from, PlaneQuery(state, start, body, p).enclose().t_lo);
    return outside(state.frame, from, time,
                   [&](const EpochTime& t) { return certified_penetration(state, flown(state, body, t), body, p); });
}

Enclosure<DoubleDouble> pair_wait(const State& state, const Flown& a, BodyId id_a, const Flown& b, BodyId id_b)
{
    const DoubleDouble3 r = lifted_separation(state.frame, a, b);
    const Vec3 v = a.flight.velocity - b.flight.velocity;
    const double length = largest(r) + state.frame.cell_size;
    return enclose(r, exactly(v), two_sum(state.radius(id_a), state.radius(id_b)),
                   {0x1p-90 * length, 2 * u * (largest(a.flight.velocity) + largest(b.flight.velocity)), 0});
}

Enclosure<DoubleDouble> plane_wait(const State& state, const Flown& a, BodyId id, int p)
{
    return PlaneQuery(state, a, id, p).enclose_rounded();
}

int exact_approach_sign(const State& state, const Flown& a, const Flown& b)
{
    const DoubleDouble3 r = lifted_separation(state.frame, a, b);
    const Vec3 v = a.flight.velocity - b.flight.velocity;
    const double p[3] = {r.x.high * v.x(), r.y.high * v.y(), r.z.high * v.z()};
    const double sum = p[0] + p[1] + p[2], scale = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
    // v is rounded once, and so may be far from a difference that nearly cancels: its own scale counts, too.
    if (std::abs(sum) > 16 * u * (scale + largest(r) * (largest(a.flight.velocity) + largest(b.flight.velocity))))
        return sum < 0 ? -1 : 1;
    return exact_approach(exact_separation(state.frame, a, b), exact_difference(a.flight.velocity, b.flight.velocity))
        .sign();
}

int exact_plane_sign(const Vec3& n, const Vec3& v)
{
    const double p[3] = {n.x() * v.x(), n.y() * v.y(), n.z() * v.z()};
    const double sum = p[0] + p[1] + p[2];
    if (std::abs(sum) > 8 * u * (std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]))) return sum < 0 ? -1 : 1;
    return (Dyadic(n.x()) * Dyadic(v.x()) + Dyadic(n.y()) * Dyadic(v.y()) + Dyadic(n.z()) * Dyadic(v.z())).sign();
}

double certified_penetration(const State& state, const Flown& a, BodyId id_a, const Flown& b, BodyId id_b)
{
    const DoubleDouble s = two_sum(state.radius(id_a), state.radius(id_b));
    Bounded c = squared_gap(lifted_separation(state.frame, a, b), s);
    if (c.open) c.sign = exact_gap(exact_separation(state.frame, a, b), Dyadic(s)).sign();
    return c.sign >= 0 ? 0 : -c.value.high / (2 * s.high);
}

double certified_penetration(const State& state, const Flown& a, BodyId id, int p)
{
    return PlaneQuery(state, a, id, p).overlap();
}

}  // namespace carom
