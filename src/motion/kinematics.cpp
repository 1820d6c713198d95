#include "motion/kinematics.hpp"

#include "motion/clock.hpp"
#include "motion/plane_query.hpp"

namespace carom {

namespace {

ContactTime contact_time(const Frame& frame, const EpochTime& from, const Enclosure<DoubleDouble>& e)
{
    if (e.decided == Decision::none) return {};
    if (e.decided == Decision::pressed) return {true, from, true, false};
    // After a wait of many epochs the rounding of the head is many steps of a time's resolution.
    const double head = e.t_lo.low < 0 ? std::nextafter(e.t_lo.high, 0.0) : e.t_lo.high;
    return {true, rough_time(frame, from, head), true, false};
}

/// Whether two spheres certainly separate: half of all pairs end here.
bool certainly_separating(const Vec3& r, const Vec3& v, const SphereInputError& error)
{
    const double p1 = r.x() * v.x(), p2 = r.y() * v.y(), p3 = r.z() * v.z();
    const double rs = std::abs(r.x()) + std::abs(r.y()) + std::abs(r.z()),
                 vs = std::abs(v.x()) + std::abs(v.y()) + std::abs(v.z());
    const double bound = dot_rounding * (std::abs(p1) + std::abs(p2) + std::abs(p3)) +
                         2 * (error.v * rs + error.r * vs) + 4 * error.r * error.v;
    // An overflow or underflow must not pass for certain.
    return p1 + p2 + p3 > bound && bound > least_certain;
}

/// Whether a sphere has certainly no speed and no acceleration towards a plane that is no plate: most walls, most of
/// the time.
bool certainly_receding(const State& state, const Flight& f, int p)
{
    const Plane& plane = state.plane(p);
    if (plane.thickness || !(plane.normal.dot(f.velocity) > normal_component_rounding * largest(f.velocity)))
        return false;
    if (f.acceleration == Accelerations::none) return true;
    const Vec3& g = state.acceleration(f);
    bool across = true;  // gravity along the plane, to the last bit
    for (int k = 0; k < 3; ++k) across = across && (plane.normal[k] == 0 || g[k] == 0);
    return across || plane.normal.dot(g) > normal_component_rounding * largest(g);
}

/// Errors of the relative motion in double against the exact one.
SphereInputError input_error(const State& state, const Flight& a, const Flight& b, const Relative<double>& m)
{
    const Flight& older = a.start < b.start ? a : b;
    const double dt = state.frame.between(older.start, m.from);
    const double g = largest(state.acceleration(older)), speed = largest(older.velocity) + dt * g;
    const double dt_error = elapsed_rounding * dt + offset_rounding * state.frame.epoch_length;
    SphereInputError error;
    error.r = flown_place_rounding * (largest(m.r) + state.frame.cell_size + dt * speed) + dt_error * speed;
    error.v = flown_speed_rounding * (largest(m.v) + speed) + dt_error * g;
    return error;
}

/// A time at which nothing overlaps: places are rounded, and may lie on the wrong side of a contact by 2^-100 or so.
template <class Depth>
EpochTime outside(const Frame& frame, const EpochTime& from, EpochTime time, const Depth& overlap_at)
{
    for (int i = 0; i < most_steps_outside && from < time && time != never && overlap_at(time) > 0; ++i)
        time = step_back(frame, from, time);
    return time;
}

/// Coordinate k of a place becomes `sum`, local and low part, counted from its present cell [length].
void put_into_cell(const Frame& frame, Place& place, int k, DoubleDouble sum)
{
    const double whole = std::floor(sum.high / frame.cell_size);
    if (whole != 0 && std::abs(whole) < furthest) {
        sum = sum - DoubleDouble(whole * frame.cell_size);
        place.cell[k] += static_cast<std::int64_t>(whole);
    }
    const bool below = sum.high < 0;  // by a rounding: the head was the wall itself
    place.local[k] = below ? 0 : sum.high;
    place.low[k] = below ? sum.high : sum.low;
}

}  // namespace

bool is_certified_gap(const State& state, BodyId a, Partner b)
{
    if (!b.is_sphere()) return flies_certified(state, a);
    const auto simple = [&](BodyId body) { return flies_certified(state, body) || state.is_fixed(body); };
    return state.certified() && simple(a) && simple(b.index) &&
           state.flight(a).acceleration == state.flight(b.index).acceleration;
}

ContactTime CertifiedKinematics::pair_time(const State& state, BodyId a, BodyId b, const EpochTime& limit)
{
    if (!is_certified_gap(state, a, Partner::sphere(b))) return PlainKinematics<true>::pair_time(state, a, b, limit);
    const Flight &fa = state.flight(a), &fb = state.flight(b);
    const auto m = relative_motion<double>(state, fa, fb);
    const SphereInputError error = input_error(state, fa, fb, m);
    if (certainly_separating(m.r, m.v, error)) return {};
    const Enclosure<double> quick = enclose(m.r, m.v, state.radius(a) + state.radius(b), error);
    if (quick.decided == Decision::none) return {};
    if (quick.decided == Decision::impact) return {true, rough_time(state.frame, m.from, quick.t_lo), true, false};
    const PairQuery pair(state, fa, a, fb, b);
    return contact_time(state.frame, pair.from, pair.enclose());
}

ContactTime CertifiedKinematics::plane_time(const State& state, const Moving& sphere, int p, const EpochTime& limit)
{
    if (!flies_certified(state, sphere.body)) return PlainKinematics<true>::plane_time(state, sphere, p, limit);
    const Flight& f = sphere.flight;
    if (certainly_receding(state, f, p)) return {};
    const PlaneMotion m = plane_motion(state, sphere, p);
    const double g = largest(state.acceleration(f));
    const PlaneInputError error{height_rounding * (std::abs(m.h) + state.frame.cell_size),
                                normal_component_rounding * largest(f.velocity), normal_component_rounding * g};
    const Enclosure<double> quick = enclose_plane(m.h, m.w, m.g, error);
    if (quick.decided == Decision::none) return {};
    if (quick.decided == Decision::impact) return {true, rough_time(state.frame, f.start, quick.t_lo), true, false};
    return contact_time(state.frame, f.start, PlaneQuery(state, f, sphere.body, p).enclose());
}

EpochTime CertifiedKinematics::exact_time(const State& state, BodyId a, Partner b)
{
    const Flight& fa = state.flight(a);
    const auto depth_at = [&](const EpochTime& t) {
        const Flight now = flown(state, a, t);
        if (b.is_plane()) return penetration(state, now, a, b.index);
        const Flight other = flown(state, b.index, t);
        return SphereEncounter(state, now, a, other, b.index).penetration();
    };
    if (b.is_plane()) {
        const DoubleDouble t = PlaneQuery(state, fa, a, b.index).enclose().t_lo;
        return outside(state.frame, fa.start, no_later(state.frame, fa.start, t), depth_at);
    }
    const PairQuery pair(state, fa, a, state.flight(b.index), b.index);
    return outside(state.frame, pair.from, no_later(state.frame, pair.from, pair.enclose().t_lo), depth_at);
}

Flight flown(const State& state, BodyId body, const EpochTime& now)
{
    if (!flies_certified(state, body)) return advanced(state, body, now);
    Flight f = state.flight(body);
    const auto dt = elapsed<DoubleDouble>(state.frame, f.start, now);
    if (dt.high == 0) return f;
    const Vec3& g = state.acceleration(f);
    for (int k = 0; k < 3; ++k) {
        const DoubleDouble from = DoubleDouble(f.place.local[k]) + DoubleDouble(f.place.low[k]);
        put_into_cell(state.frame, f.place, k, from + displacement<DoubleDouble>(f.velocity[k], g[k], dt));
        f.velocity[k] = static_cast<double>(velocity_after<DoubleDouble>(f.velocity[k], g[k], dt));
    }
    f.start = now;
    return f;
}

Enclosure<DoubleDouble> wait(const State& state, const Flight& a, BodyId id_a, const Flight& b, BodyId id_b)
{
    const double length = largest(separation(state.frame, a.place, b.place)) + state.frame.cell_size;
    return PairQuery(state, a, id_a, b, id_b)
        .enclose_rounded(
            {flown_to_rounding * length, flown_to_speed_rounding * (largest(a.velocity) + largest(b.velocity)), 0});
}

Enclosure<DoubleDouble> wait(const State& state, const Flight& a, BodyId body, int plane)
{
    return PlaneQuery(state, a, body, plane).enclose_rounded();
}

SphereEncounter::SphereEncounter(const State& state, const Flight& a, BodyId id_a, const Flight& b, BodyId id_b)
    : state_(state),
      a_(a),
      b_(b),
      id_a_(id_a),
      id_b_(id_b),
      certified_(state.certified() && is_certified_gap(state, id_a, Partner::sphere(id_b))),
      separation_(separation(state.frame, a.place, b.place)),
      distance_(std::sqrt(separation_.squaredNorm())),
      contact_distance_(state.radius(id_a) + state.radius(id_b)),
      normal_(separation_ / distance_)
{
}

int SphereEncounter::approach_sign() const
{
    return certified_ ? exactly().approach_sign() : carom::approach_sign(separation_, velocity());
}

double SphereEncounter::penetration() const
{
    return certified_ ? exactly().overlap() : std::max(0.0, -gap());
}

int approach_sign(const State& state, const Flight& flight, BodyId body, int plane)
{
    const Vec3 normal = facing_normal(state, plane, flight.place);
    const double sum = normal.dot(flight.velocity);
    if (!flies_certified(state, body) ||
        std::abs(sum) > dot_rounding * normal.cwiseProduct(flight.velocity).cwiseAbs().sum())
        return sum < 0 ? -1 : sum > 0 ? 1 : 0;
    return PlaneQuery(state, flight, body, plane).w().sign();
}

double penetration(const State& state, const Flight& flight, BodyId body, int plane)
{
    return flies_certified(state, body) ? PlaneQuery(state, flight, body, plane).overlap()
                                        : std::max(0.0, -height_above(state, body, plane, flight.place));
}

}  // namespace carom
