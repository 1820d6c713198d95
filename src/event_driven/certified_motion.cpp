#include "event_driven/certified_motion.hpp"

#include "toi/level_1.hpp"
#include "toi/plane_solver.hpp"

#include <cmath>

namespace carom {

namespace {

constexpr double u = unit_roundoff;
constexpr double dd_error = 0x1p-100;  ///< relative error of a few operations in double-double, with room

DoubleDouble lifted_between(const Frame& frame, const EpochTime& from, const EpochTime& to)
{
    return DoubleDouble(static_cast<double>(to.epoch - from.epoch) * frame.epoch_length) +
           DoubleDouble(two_sum(to.offset, -from.offset));
}
Dyadic exact_between(const Frame& frame, const EpochTime& from, const EpochTime& to)
{
    return Dyadic(static_cast<double>(to.epoch - from.epoch) * frame.epoch_length) + Dyadic(to.offset) -
           Dyadic(from.offset);
}

/// One step of the resolution of times down, but not before `from`.
EpochTime step_back(const Frame& frame, const EpochTime& from, const EpochTime& t)
{
    EpochTime back = t;
    if (back.offset > 0) {
        back.offset = std::max(0.0, back.offset - u * frame.epoch_length);
        if (back.offset == t.offset) back.offset = std::nextafter(t.offset, 0.0);
    } else {
        back = {t.epoch - 1, std::nextafter(frame.epoch_length, 0.0)};
    }
    return std::max(back, from);
}

/// A time well before from + t, by roundings; the exact contact is not before from + t.
EpochTime rough_time(const Frame& frame, const EpochTime& from, double t)
{
    EpochTime time = frame.after(from, t);
    for (int i = 0; i < 6 && from < time && time != never; ++i) time = step_back(frame, from, time);
    return time;
}

/// t + by, `by` of either sign and below 2^52 epochs.
EpochTime shifted(const Frame& frame, const EpochTime& t, double by)
{
    const double sum = t.offset + by, whole = std::floor(sum / frame.epoch_length);
    const double offset = std::max(0.0, sum - whole * frame.epoch_length);
    return {t.epoch + static_cast<std::int64_t>(whole), std::min(offset, std::nextafter(frame.epoch_length, 0.0))};
}

/// The latest time, to the resolution or a few of its steps, not after from + t.
EpochTime no_later(const Frame& frame, const EpochTime& from, DoubleDouble t)
{
    EpochTime time = frame.after(from, t.high);
    if (time == never) return time;
    // After a long wait the last bit of t.high is many steps of the resolution.
    const DoubleDouble rest = t - lifted_between(frame, from, time);
    if (std::abs(rest.high) > u * frame.epoch_length) time = std::max(from, shifted(frame, time, rest.high));
    constexpr int most_steps = 16;
    for (int i = 0; i < most_steps && from < time && lifted_between(frame, from, time) > t; ++i)
        time = step_back(frame, from, time);
    return time;
}

DoubleDouble3 lifted_separation(const Frame& frame, const Flown& a, const Flown& b)
{
    DoubleDouble r[3];
    for (int k = 0; k < 3; ++k) {
        const Place &pa = a.flight.place, &pb = b.flight.place;
        r[k] = (DoubleDouble(static_cast<double>(pa.cell[k] - pb.cell[k]) * frame.cell_size) +
                DoubleDouble(two_sum(pa.local[k], -pb.local[k]))) +
               DoubleDouble(two_sum(a.low[k], -b.low[k]));
    }
    return {r[0], r[1], r[2]};
}

/// A coordinate of a body at its flight's start, relative to cell `origin`.
Dyadic exact_coordinate(const Frame& frame, const Flight& f, const Vec3& low, int k, std::int64_t origin)
{
    return Dyadic(static_cast<double>(f.place.cell[k] - origin) * frame.cell_size) + Dyadic(f.place.local[k]) +
           Dyadic(low[k]);
}

Dyadic3 exact_separation(const Frame& frame, const Flown& a, const Flown& b)
{
    Dyadic r[3];
    for (int k = 0; k < 3; ++k) {
        const std::int64_t origin = b.flight.place.cell[k];
        r[k] =
            exact_coordinate(frame, a.flight, a.low, k, origin) - exact_coordinate(frame, b.flight, b.low, k, origin);
    }
    return {r[0], r[1], r[2]};
}
Dyadic3 exact_difference(const Vec3& a, const Vec3& b)
{
    return {Dyadic(a.x()) - Dyadic(b.x()), Dyadic(a.y()) - Dyadic(b.y()), Dyadic(a.z()) - Dyadic(b.z())};
}

Flown at_start(const State& state, BodyId body)
{
    return {state.flight(body), state.low[static_cast<std::size_t>(body)]};
}

/// Two spheres in uniform relative motion from the later of their starts, in double-double and, on demand, exactly.
class PairFromLaterStart {
public:
    PairFromLaterStart(const State& state, BodyId a, BodyId b)
        : state_(state), a_(at_start(state, a)), b_(at_start(state, b)), s_(two_sum(state.radius(a), state.radius(b)))
    {
        a_is_older_ = a_.flight.start < b_.flight.start;
        from = std::max(a_.flight.start, b_.flight.start);
        const Flown& older = a_is_older_ ? a_ : b_;
        const DoubleDouble dt = lifted_between(state.frame, older.flight.start, from);
        const Vec3& g = state.accelerations[older.flight.acceleration];
        r_ = lifted_separation(state.frame, a_, b_);
        v_ = {two_sum(a_.flight.velocity.x(), -b_.flight.velocity.x()),
              two_sum(a_.flight.velocity.y(), -b_.flight.velocity.y()),
              two_sum(a_.flight.velocity.z(), -b_.flight.velocity.z())};
        const double t = dt.high;
        error_.r = dd_error * (largest(r_) + state.frame.cell_size);
        if (t == 0) return;
        const DoubleDouble half = dt * DoubleDouble(0.5);
        const auto moved_by = [&](double v0, double acceleration) {
            return dt * (DoubleDouble(v0) + half * DoubleDouble(acceleration));
        };
        const Vec3& v0 = older.flight.velocity;
        const DoubleDouble3 shift{moved_by(v0.x(), g.x()), moved_by(v0.y(), g.y()), moved_by(v0.z(), g.z())};
        const DoubleDouble3 gain{dt * DoubleDouble(g.x()), dt * DoubleDouble(g.y()), dt * DoubleDouble(g.z())};
        r_ = a_is_older_ ? r_ + shift : r_ - shift;
        v_ = a_is_older_ ? v_ + gain : v_ - gain;
        const double speed = largest(v0) + t * largest(g);
        error_.r += dd_error * (largest(r_) + t * speed);
        error_.v = dd_error * (largest(v_) + speed);
    }

    Enclosure<DoubleDouble> enclose() const
    {
        const double length = std::max({largest(r_), s_.high, error_.r}), speed = std::max(largest(v_), error_.v);
        Enclosure<DoubleDouble> out;
        if (!(speed > 0)) return out;
        const bool moderate = is_moderate(length) && is_moderate(speed);
        const int l = moderate ? 0 : exponent_of(length), w = moderate ? 0 : exponent_of(speed);
        const SphereLevel1 query{
            scaled(r_, -l), scaled(v_, -w), scaled(s_, -l), {std::ldexp(error_.r, -l), std::ldexp(error_.v, -w), 0}};
        out = solve_level_1(query, Exactly{*this, l, w});
        if (l != w) rescale_time(out, l - w);
        return out;
    }

    EpochTime from;

private:
    /// See ExactSphere of toi/level_1.hpp.
    struct Exactly {
        static constexpr bool available = true;
        const PairFromLaterStart& pair;
        int length, speed;

        Dyadic approach() const { return exact_approach(pair.exact_r(), pair.exact_v()); }
        Dyadic gap() const { return exact_gap(pair.exact_r(), Dyadic(pair.s_)); }
        Dyadic discriminant() const { return exact_discriminant(pair.exact_r(), pair.exact_v(), Dyadic(pair.s_)); }
        int exponent_of_b() const { return approach().exponent() - length - speed; }
        int exponent_of_c() const { return gap().exponent() - 2 * length; }
        Bounded b(int more = 0) const { return settled(approach(), more - length - speed); }
        Bounded c(int more = 0) const { return settled(gap(), more - 2 * length); }
        Bounded d(int more = 0) const { return settled(discriminant(), 2 * (more - length - speed)); }
    };

    Dyadic3 exact_r() const
    {
        const Flown& older = a_is_older_ ? a_ : b_;
        const Dyadic dt = exact_between(state_.frame, older.flight.start, from);
        const Dyadic half = dt * Dyadic(0.5);
        const Vec3 &g = state_.accelerations[older.flight.acceleration], &v0 = older.flight.velocity;
        const auto moved_by = [&](int k) { return dt * (Dyadic(v0[k]) + half * Dyadic(g[k])); };
        const Dyadic3 r = exact_separation(state_.frame, a_, b_);
        return a_is_older_ ? Dyadic3{r.x + moved_by(0), r.y + moved_by(1), r.z + moved_by(2)}
                           : Dyadic3{r.x - moved_by(0), r.y - moved_by(1), r.z - moved_by(2)};
    }
    Dyadic3 exact_v() const
    {
        const Flown& older = a_is_older_ ? a_ : b_;
        const Dyadic dt = exact_between(state_.frame, older.flight.start, from);
        const Vec3& g = state_.accelerations[older.flight.acceleration];
        const Dyadic3 v = exact_difference(a_.flight.velocity, b_.flight.velocity);
        return a_is_older_ ? Dyadic3{v.x + dt * Dyadic(g.x()), v.y + dt * Dyadic(g.y()), v.z + dt * Dyadic(g.z())}
                           : Dyadic3{v.x - dt * Dyadic(g.x()), v.y - dt * Dyadic(g.y()), v.z - dt * Dyadic(g.z())};
    }

    const State& state_;
    Flown a_, b_;
    bool a_is_older_ = false;
    DoubleDouble s_;
    DoubleDouble3 r_, v_;
    SphereInputError error_;
};

/// Height above contact with a plane, on the side of `normal`, its rate and acceleration: in double-double and exactly.
class PlaneQuery {
public:
    PlaneQuery(const State& state, const Flown& sphere, BodyId body, int p)
        : state_(state), sphere_(sphere), plane_(state.plane(p)), radius_(state.radius(body))
    {
        side_ = facing_normal(state, p, sphere.flight.place) == plane_.normal ? 1 : -1;
        const Flight& f = sphere.flight;
        DoubleDouble h = -plane_.offset;
        double scale = std::abs(plane_.offset) + radius_;
        for (int k = 0; k < 3; ++k) {
            const double n = plane_.normal[k];
            if (n == 0) continue;
            const double cells = static_cast<double>(f.place.cell[k]) * state.frame.cell_size;
            h = h + DoubleDouble(two_product(n, cells)) + DoubleDouble(two_product(n, f.place.local[k])) +
                DoubleDouble(n * sphere.low[k]);
            scale += std::abs(n * cells) + state.frame.cell_size;
        }
        h = DoubleDouble(side_) * h - DoubleDouble(plane_.thickness.value_or(0) / 2) - DoubleDouble(radius_);
        h_ = {h, dd_error * scale};
        w_ = along(f.velocity);
        g_ = along(state.accelerations[f.acceleration]);
    }

    Enclosure<DoubleDouble> enclose() const { return PlaneSolver<DoubleDouble, PlaneQuery>(h_, w_, g_, *this).solve(); }
    /// Without the exact values: the places are roundings themselves.
    Enclosure<DoubleDouble> enclose_rounded() const
    {
        return PlaneSolver<DoubleDouble, NoExactPlane>(h_, w_, g_, {}).solve();
    }

    double overlap() const
    {
        if (h_.is_positive() || h().sign() >= 0) return 0;
        return -h_.value.high;
    }

    // What PlaneSolver wants of exact numbers.
    static constexpr bool available = true;
    Dyadic h() const
    {
        Dyadic sum = -Dyadic(plane_.offset);
        for (int k = 0; k < 3; ++k)
            sum = sum + Dyadic(plane_.normal[k]) * exact_coordinate(state_.frame, sphere_.flight, sphere_.low, k, 0);
        return Dyadic(side_) * sum - Dyadic(plane_.thickness.value_or(0) / 2) - Dyadic(radius_);
    }
    Dyadic w() const { return exact_along(sphere_.flight.velocity); }
    Dyadic g() const { return exact_along(state_.accelerations[sphere_.flight.acceleration]); }

private:
    Bounded along(const Vec3& x) const
    {
        DoubleDouble sum;
        double scale = 0;
        for (int k = 0; k < 3; ++k) {
            const Sum product = two_product(plane_.normal[k], x[k]);
            sum = sum + DoubleDouble(product);
            scale += std::abs(product.high);
        }
        return {DoubleDouble(side_) * sum, dd_error * scale};
    }
    Dyadic exact_along(const Vec3& x) const
    {
        const Vec3& n = plane_.normal;
        return Dyadic(side_) *
               (Dyadic(n.x()) * Dyadic(x.x()) + Dyadic(n.y()) * Dyadic(x.y()) + Dyadic(n.z()) * Dyadic(x.z()));
    }

    const State& state_;
    const Flown& sphere_;
    const Plane& plane_;
    double radius_, side_;
    Bounded h_, w_, g_;
};

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

Flown flown(const State& state, BodyId body, const EpochTime& now)
{
    const Flight& f = state.flight(body);
    if (!state.certified() || !flies_freely(f)) return {advanced(state, body, now), Vec3::Zero()};
    Flown out = at_start(state, body);
    const DoubleDouble dt = lifted_between(state.frame, f.start, now);
    if (dt.high == 0) return out;
    const double size = state.frame.cell_size;
    const Vec3& g = state.accelerations[f.acceleration];
    const DoubleDouble half = dt * DoubleDouble(0.5);
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble shift = dt * (DoubleDouble(f.velocity[k]) + half * DoubleDouble(g[k]));
        DoubleDouble sum = (DoubleDouble(f.place.local[k]) + DoubleDouble(out.low[k])) + shift;
        const double whole = std::floor(sum.high / size);
        if (whole != 0 && std::abs(whole) < furthest) {
            sum = sum - DoubleDouble(whole * size);
            out.flight.place.cell[k] += static_cast<std::int64_t>(whole);
        }
        const bool below = sum.high < 0;  // by a rounding: the head was the wall itself
        out.flight.place.local[k] = below ? 0 : sum.high;
        out.low[k] = below ? sum.high : sum.low;
        out.flight.velocity[k] = static_cast<double>(DoubleDouble(f.velocity[k]) + dt * DoubleDouble(g[k]));
    }
    out.flight.start = now;
    return out;
}

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
