#include "event_driven/numeric_motion.hpp"

#include "event_driven/height.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/piece.hpp"
#include "math/error_free.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

/// Of the smallest radius: see NumericCluster. A ball that rolls off another one as gravity has it needs 1e-8, in a
/// step of h.
constexpr double agreement = 3e-7;

/// Contact of body number `a` with number `b` or what does not move; places relative to `centre`.
NumericContact numeric_contact(const State& state, const NumericPart& part, const NumericPart::Contact& contact,
                               const Place& centre)
{
    const auto number = [&](BodyId body) -> std::optional<int> {
        const auto found = std::lower_bound(part.bodies.begin(), part.bodies.end(), body,
                                            [](const NumericPart::Body& b, BodyId id) { return b.id < id; });
        if (found == part.bodies.end() || found->id != body) return immovable;
        return static_cast<int>(found - part.bodies.begin());
    };
    const Touch& t = contact.touch;
    NumericContact out;
    const std::optional<int> a = number(t.a), b = number(t.b);
    out.a = a ? *a : *b;
    out.b = a ? b : immovable;
    out.force = contact.force;
    if (state.is_plane(t.b)) {
        const Flight& f = part.bodies[static_cast<std::size_t>(out.a)].flight;
        out.plane = true;
        out.centre = t.normal / std::sqrt(t.normal.squaredNorm());
        out.reach = out.centre.dot(separation(state.frame, f.place, centre)) - t.gap;
        return out;
    }
    out.reach = state.radius(t.a) + state.radius(t.b);
    if (!out.b) out.centre = separation(state.frame, contact.other, centre);
    return out;
}

/// Largest overlap of the parabolas after a time.
double depth(const NumericCluster& cluster, const std::vector<Vec3>& accelerations, double time)
{
    const auto at = [&](int body) {
        const auto k = static_cast<std::size_t>(body);
        const NumericBody& b = cluster.bodies[k];
        return Vec3(b.position + displacement(b.velocity, accelerations[k], time));
    };
    double deepest = 0;
    for (const NumericContact& c : cluster.contacts) {
        const Vec3 a = at(c.a);
        const Vec3 r = a - (c.plane ? Vec3::Zero() : c.b ? at(*c.b) : c.centre);
        const double gap = c.plane ? c.centre.dot(r) - c.reach : std::sqrt(r.squaredNorm()) - c.reach;
        deepest = std::max(deepest, -gap);
    }
    return deepest;
}

/// A heap that is hot is interrupted all the time, and what was found for later times is of no use: a step is no longer
/// than four times the last ones came to, on average over the bodies.
double step_length(const State& state, const NumericPart& part, const EpochTime& now)
{
    constexpr double growth = 4, shortest = 0x1p-6;
    const double h = state.rest.numeric_step;
    double sum = 0;
    int count = 0;
    for (const NumericPart::Body& body : part.bodies) {
        const Flight& before = state.flight(body.id);
        if (before.mode != Mode::numeric) continue;
        sum += state.frame.between(before.start, now);
        ++count;
    }
    return count == 0 ? h : std::clamp(growth * sum / count, shortest * h, h);
}

/// A body as its piece has it within the step; others as they fly.
Flight flight_within(const State& state, BodyId body, const EpochTime& time)
{
    Flight f = advanced(state, body, time);
    if (f.mode != Mode::numeric) return f;
    const Piece& piece = state.pieces.at(body);
    if (!piece.cluster) return f;
    const double t = state.frame.between(state.flight(body).start, time);
    const NumericBody at = within_step(*piece.cluster, *piece.step, static_cast<std::size_t>(piece.index), t);
    f.place = moved(state.frame, piece.centre, at.position);
    f.velocity = at.velocity;
    return f;
}

}  // namespace

EpochTime time_of_contact(const State& state, const Key& key, const EpochTime& earliest)
{
    const bool plane = state.is_plane(key.b);
    const auto is_numeric = [&](BodyId body) {
        return state.flight(body).mode == Mode::numeric && state.pieces.at(body).cluster != nullptr;
    };
    if (!is_numeric(key.a) && (plane || !is_numeric(key.b))) return key.time;
    // Newton's method from the right, between a time before the contact and one after it.
    const double latest = state.frame.between(earliest, key.time);
    double t = latest, before = -1, after = latest;
    constexpr int steps = 8;
    for (int i = 0; i < steps; ++i) {
        const EpochTime time = state.frame.after(earliest, t);
        const Flight a = flight_within(state, key.a, time);
        const Flight b = plane ? Flight{} : flight_within(state, key.b, time);
        const Touch contact = touch(state, key.a, a, key.b, plane ? nullptr : &b);
        const double rate = contact.normal.dot(plane ? a.velocity : Vec3(a.velocity - b.velocity));
        if (i == 0 && !(contact.gap < 0)) return key.time;
        if (i == 0 && !(rate < 0)) return key.time;
        // What opens is the end of an earlier contact.
        const bool close = std::abs(contact.gap) <= unit_roundoff * state.radius(key.a);
        const bool closed = (contact.gap < 0 || close) && rate < 0;
        (closed ? after : before) = t;
        if ((closed && close) || !(after > 0)) break;
        const double newton = rate < 0 ? t - contact.gap / rate : before;
        if (before < newton && newton < after)
            t = std::max(newton, 0.0);
        else
            t = before < 0 ? 0 : before + (after - before) / 2;
    }
    return after < latest ? state.frame.after(earliest, after) : key.time;
}

NumericMotion numeric_motion(const State& state, const NumericPart& part, const EpochTime& now, double opening)
{
    const Place centre = part.bodies.front().flight.place;
    auto cluster = std::make_shared<NumericCluster>();
    cluster->gravity = state.accelerations[state.accelerations.free()];
    cluster->opening = opening;
    double radius = std::numeric_limits<double>::infinity();
    for (const NumericPart::Body& body : part.bodies) radius = std::min(radius, state.radius(body.id));
    cluster->agreement = agreement * radius;
    for (const NumericPart::Body& body : part.bodies)
        cluster->bodies.push_back(
            {separation(state.frame, body.flight.place, centre), body.flight.velocity, state.inverse_mass(body.id)});
    for (const NumericPart::Contact& contact : part.contacts)
        cluster->contacts.push_back(numeric_contact(state, part, contact, centre));
    const auto step = std::make_shared<NumericStep>(numeric_step(*cluster, step_length(state, part, now)));

    NumericMotion out;
    out.opened = step->opened;
    out.forces = step->forces;
    out.correction = step->correction;
    for (std::size_t k = 0; k < part.bodies.size(); ++k) {
        out.pieces.push_back(
            {state.frame.after(now, step->duration), Vec3::Zero(), cluster, step, static_cast<int>(k), centre});
        // The parabola that ends where the motion does, if its acceleration changes at a steady rate: no difference of
        // places, which what is put back, and rounding, would make enormous in a brief step.
        out.accelerations.push_back((2 * step->start_accelerations[k] + step->end_accelerations[k]) / 3);
    }
    out.depth = depth(*cluster, out.accelerations, 2 * step->duration / 3);
    return out;
}

}  // namespace carom
