#include "event_driven/resolve.hpp"

#include "core/expect.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/settle.hpp"
#include "impact/pair_law.hpp"
#include "math/error_free.hpp"
#include "toi/sphere_plane.hpp"
#include "toi/sphere_sphere.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

constexpr int most_nudges = 64;

std::string names(const State& state, BodyId a, BodyId b)
{
    return state.scene.body_name(a) + " and " + state.scene.body_name(b);
}

/// Does the contact, closed at this instant, close further? \pre a is a sphere; flights are of this instant.
bool closing_contact(const State& state, const Flight& a, BodyId id_a, const Flight& b, BodyId id_b)
{
    const double radius = std::min(state.radius(id_a), state.radius(id_b));
    const Vec3 r = separation(state.frame, a.place, b.place);
    const double reach = state.radius(id_a) + state.radius(id_b) + tie_fraction * radius;
    return r.squaredNorm() <= reach * reach && approach_sign(r, a.velocity - b.velocity) < 0;
}

bool closing_contact(const State& state, const Flight& a, BodyId id, int plane)
{
    if (height_above(state, id, plane, a.place) > tie_fraction * state.radius(id)) return false;
    return facing_normal(state, plane, a.place).dot(a.velocity) < 0;
}

/// Another contact of `body` that is closed and closing at this very instant, next to the one with `partner`; no_body
/// if none.
BodyId other_closing(const State& state, const Flight& now, BodyId body, BodyId partner,
                     const Neighbourhood& neighbourhood)
{
    BodyId found = no_body;
    for (int p = 0; p < static_cast<int>(state.scene.planes.size()); ++p)
        if (state.scene.plane_body(static_cast<std::size_t>(p)) != partner && p != now.support &&
            closing_contact(state, now, body, p))
            found = state.scene.plane_body(static_cast<std::size_t>(p));
    for (const BodyId other : neighbourhood(body)) {
        if (other == partner) continue;
        const Flight& f = state.flight(other);
        // A cheap look first: nothing beyond a generous ball can touch.
        const double dt = state.frame.between(f.start, now.start);
        const Vec3 shift = displacement(f.velocity, state.accelerations[f.acceleration], dt);
        const Vec3 r = separation(state.frame, now.place, f.place) - shift;
        const double reach = state.radius(body) + state.radius(other);
        if (f.mode != Mode::series && r.squaredNorm() > 1.0001 * reach * reach) continue;
        if (closing_contact(state, now, body, advanced(state, other, now.start), other)) found = other;
    }
    return found;
}

/// Was this contact already closed, and closing, when the later of its flights began at an impact? Then it belonged to
/// that impact.
bool belongs_to_previous_instant(const State& state, const Key& key)
{
    const bool with_plane = state.is_plane(key.b);
    const Flight& a = state.flight(key.a);
    const auto changed = [&](BodyId body) { return state.stamps[static_cast<std::size_t>(body)] > 0; };
    if (with_plane) {
        if (!changed(key.a)) return false;
        const PlaneMotion m = plane_motion(state, moving(state, key.a), state.plane_index(key.b));
        return m.h <= tie_fraction * state.radius(key.a) && m.w < 0;
    }
    const Flight& b = state.flight(key.b);
    const BodyId later = a.start < b.start ? key.b : key.a;
    if (!changed(later)) return false;
    const PairMotion m = pair_motion(state, moving(state, key.a), moving(state, key.b));
    const double reach = m.contact_distance + tie_fraction * std::min(state.radius(key.a), state.radius(key.b));
    return m.r.squaredNorm() <= reach * reach && approach_sign(m.r, m.v) < 0;
}

std::string several_contacts(const std::string& one, const std::string& other)
{
    return "several contacts close at one instant (" + one + "; " + other + "): coupled impacts are not resolved yet";
}

/// Impulses leave rounding behind. A body on a support keeps to its plane: its normal speed is put back to 0 if the
/// impulse left none to speak of, it is released if pulled off. Returns false if it is pushed into the plane: a coupled
/// impact.
bool keep_to_support(const State& state, BodyId id, Flight& f, Resolution& out)
{
    if (f.support < 0) return true;
    const Vec3 normal = facing_normal(state, f.support, f.place);
    const double c = normal.dot(f.velocity) / normal.squaredNorm();
    const double slack =
        std::max(1e-6 * state.rest.closing_speed, 16 * unit_roundoff * std::sqrt(f.velocity.squaredNorm()));
    if (std::abs(c) <= slack) {
        f.velocity -= c * normal;
        f.mode = slide_or_rest(state, f);
        return true;
    }
    if (c < 0) return false;
    out.events.push_back({EventKind::release,
                          {},
                          0,
                          id,
                          state.scene.plane_body(static_cast<std::size_t>(f.support)),
                          normal,
                          Vec3::Zero()});
    f.support = -1;
    f.mode = Mode::flying;
    f.acceleration = state.accelerations.free();
    return true;
}

Resolution resolve_spheres(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    Resolution out;
    Flight a = advanced(state, key.a, key.time), b = advanced(state, key.b, key.time);
    const Sphere &sa = state.sphere(key.a), &sb = state.sphere(key.b);
    const std::string pair = names(state, key.a, key.b);

    if (belongs_to_previous_instant(state, key)) {
        out.unresolved = several_contacts(pair, "the impact just before it");
        return out;
    }
    for (const auto& [body, flight, partner] : {std::tuple{key.a, &a, key.b}, std::tuple{key.b, &b, key.a}}) {
        const BodyId other = other_closing(state, *flight, body, partner, neighbourhood);
        if (other == no_body) continue;
        out.unresolved = several_contacts(pair, names(state, body, other));
        return out;
    }
    const Vec3 r = separation(state.frame, a.place, b.place);
    const double distance = std::sqrt(r.squaredNorm());
    out.penetration = std::max(0.0, sa.radius + sb.radius - distance);
    const Vec3 normal = r / distance;
    const bool approaching = approach_sign(r, a.velocity - b.velocity) < 0;
    if (!approaching && a.acceleration != b.acceleration &&
        pair_root(state, pair_motion(state, moving(state, key.a), moving(state, key.b))).kind == RootKind::pressed) {
        out.unresolved = pair + " stay in contact: resting on spheres is not resolved yet";
        return out;
    }

    Vec3 impulse = Vec3::Zero();
    const Vec3 before_a = a.velocity, before_b = b.velocity;
    if (approaching) {
        const PairImpact after = resolve_pair({a.velocity, 1 / sa.mass}, {b.velocity, 1 / sb.mass}, normal,
                                              state.laws.spheres(sa.material, sb.material));
        a.velocity = after.velocity_a;
        b.velocity = after.velocity_b;
        impulse = after.impulse;
    }
    out.events.push_back({EventKind::impact, {}, 0, key.a, key.b, normal, impulse});
    if (!keep_to_support(state, key.a, a, out) || !keep_to_support(state, key.b, b, out)) {
        out.unresolved = several_contacts(pair, "the plane that supports one of them");
        return out;
    }
    // The kernel must not see the pair approach again: the smallest impulse along r that makes it so (rounding only).
    const double reduced_mass = 1 / (1 / sa.mass + 1 / sb.mass);
    double nudge = 4 * unit_roundoff * (std::sqrt(before_a.squaredNorm()) + std::sqrt(before_b.squaredNorm()));
    for (int i = 0; i < most_nudges && approach_sign(r, a.velocity - b.velocity) < 0; ++i, nudge *= 2) {
        a.velocity += (nudge * reduced_mass / sa.mass) * normal;
        b.velocity -= (nudge * reduced_mass / sb.mass) * normal;
    }
    out.changes = {{key.a, a, {}}, {key.b, b, {}}};
    return out;
}

Resolution resolve_plane(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    Resolution out;
    const BodyId id = key.a;
    const int plane = state.plane_index(key.b);
    const Sphere& sphere = state.sphere(id);
    Flight f = advanced(state, id, key.time);
    const std::string pair = names(state, id, key.b);

    if (belongs_to_previous_instant(state, key)) {
        out.unresolved = several_contacts(pair, "the impact just before it");
        return out;
    }
    if (const BodyId other = other_closing(state, f, id, key.b, neighbourhood); other != no_body) {
        out.unresolved = several_contacts(pair, names(state, id, other));
        return out;
    }
    out.penetration = std::max(0.0, -height_above(state, id, plane, f.place));
    const Vec3 normal = facing_normal(state, plane, f.place);
    const ContactLaw& law = state.laws.plane(sphere.material, state.plane(plane).material);
    const double gravity = -normal.dot(state.accelerations[f.acceleration]);  // towards the plane, > 0 presses

    Vec3 impulse = Vec3::Zero();
    if (normal.dot(f.velocity) < 0) {
        const PairImpact after = resolve_pair({f.velocity, 1 / sphere.mass}, {}, normal, law);
        f.velocity = after.velocity_a;
        impulse = after.impulse;
    }
    out.events.push_back({EventKind::impact, {}, 0, id, key.b, normal, impulse});
    if (!keep_to_support(state, id, f, out)) {
        out.unresolved = several_contacts(pair, "the plane that supports it");
        return out;
    }
    double nudge = 4 * unit_roundoff * std::sqrt(f.velocity.squaredNorm());
    for (int i = 0; i < most_nudges && normal.dot(f.velocity) < 0; ++i, nudge *= 2) f.velocity += nudge * normal;

    const double w = normal.dot(f.velocity);
    if (is_rest(state, id, f, w, gravity)) {
        if (f.support >= 0) {
            out.unresolved = state.scene.body_name(id) + " comes to rest on a second plane, " +
                             state.scene.body_name(key.b) + ": contact with several planes is not resolved yet";
            return out;
        }
        settle(state, id, plane, f);
        out.events.push_back({EventKind::rest, {}, 0, id, key.b, normal, Vec3::Zero()});
        out.changes = {{id, f, {}}};
        return out;
    }
    if (law.restitution < 1 && gravity > 0 && w * w < 2 * gravity * state.scene.rest.series_below * sphere.radius) {
        const Series series = make_series(state, f, plane, w, gravity, law);
        if (f.support < 0 && series_is_clear(state, id, f, plane, series, neighbourhood)) {
            f.mode = Mode::series;
            f.support = plane;
            out.changes = {{id, f, series}};
            return out;
        }
    }
    out.changes = {{id, f, {}}};
    return out;
}

Resolution resolve_series_end(const State& state, const Key& key)
{
    Resolution out;
    const BodyId id = key.a;
    const int plane = state.plane_index(key.b);
    const Series& series = state.series.at(id);
    const Flight before = state.flight(id);
    const Vec3 normal = facing_normal(state, plane, before.place);
    const SeriesState end = state_at_end(series);

    Flight f = before;
    f.start = key.time;
    f.place = moved(state.frame, before.place, end.shift);
    f.velocity = end.velocity;
    settle(state, id, plane, f);
    // All bounces together, from the balance of momentum.
    const Vec3& g = state.accelerations[state.accelerations.free()];
    const Vec3 impulse = state.sphere(id).mass * ((f.velocity - before.velocity) - series.duration() * g);
    out.events.push_back({EventKind::rest, {}, 0, id, key.b, normal, impulse});
    out.changes = {{id, f, {}}};
    return out;
}

/// A sphere reached the ball that a series sweeps: the series becomes the bounce it is in.
Resolution resolve_intrusion(const State& state, const Key& key)
{
    Resolution out;
    for (const BodyId body : {key.a, key.b})
        if (!state.is_plane(body) && state.flight(body).mode == Mode::series)
            out.changes.push_back({body, advanced(state, body, key.time), {}});
    return out;
}

}  // namespace

Resolution resolve(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    switch (key.kind) {
        case Scheduled::pair_impact:
            return resolve_spheres(state, key, neighbourhood);
        case Scheduled::plane_impact:
            return resolve_plane(state, key, neighbourhood);
        case Scheduled::series_end:
            return resolve_series_end(state, key);
        case Scheduled::intrusion:
            return resolve_intrusion(state, key);
        case Scheduled::cell_crossing:
        case Scheduled::nothing:
            break;
    }
    CAROM_EXPECT(false);
    return {};
}

std::vector<Change> initial_contacts(const State& state)
{
    constexpr double declared = 1e-9;  // a gap within this fraction of the radius is a contact
    std::vector<Change> changes;
    for (BodyId id = 0; id < state.count(); ++id)
        for (int p = 0; p < static_cast<int>(state.scene.planes.size()); ++p) {
            Flight f = state.flight(id);
            if (std::abs(height_above(state, id, p, f.place)) > declared * state.radius(id)) continue;
            const Vec3 normal = facing_normal(state, p, f.place);
            const double gravity = -normal.dot(state.accelerations[f.acceleration]);
            if (normal.dot(f.velocity) != 0 || !(gravity > 0)) continue;
            hold(state, p, f);
            changes.push_back({id, f, {}});
            break;
        }
    return changes;
}

}  // namespace carom
