#include "hold/numeric_motion.hpp"

#include "flight/damping.hpp"
#include "hold/tolerances.hpp"
#include "motion/moment.hpp"
#include "motion/relative.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

/// \param number of the component's bodies in the cluster, where they move
/// \pre one of the contact's bodies moves
NumericContact numeric_contact(const State& state, const ContactComponent& component, const Contact& contact,
                               const std::vector<std::optional<int>>& number, const Place& centre)
{
    const auto a = static_cast<std::size_t>(contact.a);
    const std::optional<int> number_b = contact.b ? number[static_cast<std::size_t>(*contact.b)] : immovable;
    const auto place = [&](std::size_t body) { return separation(state.frame, component.flights[body].place, centre); };
    NumericContact out;
    out.a = number[a] ? *number[a] : *number_b;
    if (contact.partner.is_plane()) {
        const Vec3 normal = contact.normal / std::sqrt(contact.normal.squaredNorm());
        out.partner = FixedPlane{normal};
        out.reach = normal.dot(place(a)) - contact.gap;
        return out;
    }
    out.reach = state.radius(component.id_of_a(contact)) + state.radius(contact.partner.index);
    if (number[a] && number_b)
        out.partner = ClusterBody{*number_b};
    else if (const std::optional<int> other = number[a] ? contact.b : contact.a)
        out.partner = FixedSphere{place(static_cast<std::size_t>(*other))};
    else
        out.partner = FixedSphere{separation(state.frame, state.flight(contact.partner.index).place, centre)};
    return out;
}

/// Largest overlap of the parabolas after a time.
double depth(const NumericCluster& cluster, const std::vector<Vec3>& accelerations, double time)
{
    std::vector<NumericBody> bodies = cluster.bodies;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        bodies[k].position += cluster.drag > 0
                                  ? displacement(bodies[k].velocity, accelerations[k], damping(cluster.drag, time))
                                  : displacement(bodies[k].velocity, accelerations[k], time);
    double deepest = 0;
    for (const NumericContact& c : cluster.contacts) deepest = std::max(deepest, -c.gap(bodies));
    return deepest;
}

/// A step in a heap that is hot, and interrupted all the time, is little longer than the last ones came to, on average
/// over the bodies.
double step_length(const State& state, const ContactComponent& component, std::span<const std::size_t> part,
                   const EpochTime& now)
{
    // Runge and Kutta's method is stable and exact to h^5 where drag acts little within a step.
    const double h =
        state.drag > 0 ? std::min(state.rest.numeric_step, damped_step / state.drag) : state.rest.numeric_step;
    double sum = 0;
    int count = 0;
    for (const std::size_t k : part) {
        const BodyId body = component.id(k);
        if (!state.bodies.is_in_piece(body)) continue;
        sum += state.frame.between(state.flight(body).start, now);
        ++count;
    }
    return count == 0 ? h : std::clamp(step_growth * sum / count, shortest_step * h, h);
}

}  // namespace

EpochTime time_of_contact(const State& state, const Key& key, const EpochTime& earliest)
{
    const auto is_stepping = [&](BodyId body) { return state.bodies.kind(body) == MotionKind::stepping; };
    const bool sphere = key.b.is_sphere();
    if (!is_stepping(key.a) && !(sphere && is_stepping(key.b.index))) return key.time;
    // Newton's method from the right, between a time before the contact and one after it.
    const double latest = state.frame.between(earliest, key.time);
    double t = latest, before = -1, after = latest;
    for (int i = 0; i < most_contact_steps; ++i) {
        const EpochTime time = state.frame.after(earliest, t);
        const Flight a = flight_within_step(state, key.a, time);
        const Flight b = sphere ? flight_within_step(state, key.b.index, time) : Flight{};  // a plane stands still
        const Contact contact =
            sphere ? sphere_contact(state, key.a, a, key.b.index, b) : plane_contact(state, key.a, a, key.b.index);
        const double rate = contact.normal.dot(a.velocity - b.velocity);
        if (i == 0 && !(contact.gap < 0)) return key.time;
        if (i == 0 && !(rate < 0)) return key.time;
        // What opens is the end of an earlier contact.
        const bool close = std::abs(contact.gap) <= closed_gap * state.radius(key.a);
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

NumericMotion numeric_motion(const State& state, const ContactComponent& component, std::span<const std::size_t> part,
                             std::span<const std::size_t> held, const std::function<double(std::size_t)>& force,
                             const EpochTime& now, double opening)
{
    auto piece = std::make_shared<NumericPiece>();
    piece->centre = component.flights[part.front()].place;
    NumericCluster& cluster = piece->cluster;
    cluster.gravity = state.gravity();
    cluster.drag = state.drag;
    cluster.opening = opening;
    double radius = std::numeric_limits<double>::infinity();
    std::vector<std::optional<int>> number(component.flights.size());
    for (const std::size_t k : part) {
        radius = std::min(radius, state.radius(component.id(k)));
        number[k] = static_cast<int>(cluster.bodies.size());
        const ContactBody& body = component.problem.bodies[k];
        cluster.bodies.push_back(
            {separation(state.frame, component.flights[k].place, piece->centre), body.velocity, body.inverse_mass});
    }
    cluster.agreement = step_agreement * radius;
    std::vector<std::size_t> concerned;
    for (const std::size_t i : held) {
        const Contact& contact = component.problem.contacts[i];
        if (!number[static_cast<std::size_t>(contact.a)] &&
            !(contact.b && number[static_cast<std::size_t>(*contact.b)]))
            continue;
        concerned.push_back(i);
        cluster.contacts.push_back(numeric_contact(state, component, contact, number, piece->centre));
        cluster.contacts.back().force = force(i);
    }
    piece->step = numeric_step(cluster, step_length(state, component, part, now));
    const NumericStep& step = piece->step;

    NumericMotion out;
    for (const std::size_t n : step.opened) out.opened.push_back(concerned[n]);
    out.mean_forces.assign(component.problem.contacts.size(), 0);
    for (std::size_t n = 0; n < concerned.size(); ++n) out.mean_forces[concerned[n]] = step.forces[n];
    out.correction = step.correction;
    std::vector<Vec3> accelerations;
    // The parabola that ends where the motion does, if its acceleration changes at a steady rate: no difference of
    // places, which what is put back, and rounding, would make enormous in a brief step.
    for (std::size_t k = 0; k < part.size(); ++k)
        accelerations.push_back((2 * step.start_accelerations[k] + step.end_accelerations[k]) / 3);
    for (std::size_t k = 0; k < part.size(); ++k)
        out.pieces.push_back({state.frame.after(now, step.duration), accelerations[k], piece, k});
    out.depth = depth(cluster, accelerations, 2 * step.duration / 3);
    return out;
}

}  // namespace carom
