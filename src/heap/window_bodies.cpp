#include "heap/window_bodies.hpp"

#include "heap/tolerances.hpp"
#include "motion/height.hpp"
#include "window/contact_geometry.hpp"

#include <algorithm>

namespace carom {

double hot_length(const State& state)
{
    return window_steps * state.rest.numeric_step;
}

bool WindowBodies::is_close(std::size_t pair) const
{
    const NearPair& p = list->pairs[pair];
    const WindowBody &a = bodies[static_cast<std::size_t>(p.a)], &b = bodies[static_cast<std::size_t>(p.b.index)];
    const double gap = geometry(a, b).gap, speed = (a.velocity - b.velocity).norm();
    const double fall = hot * a.acceleration.norm();
    return gap < std::max(hot * (speed + fall_of_others * fall), heap_reach * std::min(a.radius, b.radius));
}

WindowBodies bodies_now(const State& state, Moment& moment, const std::shared_ptr<const NearPairs>& list,
                        const std::function<bool(BodyId)>& stands_still)
{
    WindowBodies out;
    out.list = list;
    const Place centre = moment.flight(list->bodies.front()).place;
    for (std::size_t i = 0; i < list->bodies.size(); ++i) {
        const BodyId body = list->bodies[i];
        const bool still = stands_still(body);
        out.still.push_back(still);
        out.flights.push_back(moment.flight(body));
        if (still) out.flights.back().velocity = Vec3::Zero();
        WindowBody each;
        each.place = separation(state.frame, out.flights.back().place, centre);
        each.velocity = out.flights.back().velocity;
        each.acceleration = still ? Vec3(Vec3::Zero()) : state.gravity();
        each.inverse_mass = still ? 0 : state.inverse_mass(body);
        each.radius = state.radius(body);
        out.bodies.push_back(each);
        out.moved.push_back(separation(state.frame, out.flights.back().place, list->places[i]).norm());
    }
    for (int p = 0; p < state.planes(); ++p) {
        const Plane& plane = state.plane(p);
        WindowPlane each;
        each.normal = plane.normal;
        each.offset = -signed_height(state.frame, plane, centre).high;
        if (plane.thickness) each.half_thickness = *plane.thickness / 2;
        out.planes.push_back(each);
    }
    out.hot = hot_length(state);
    return out;
}

void join(DisjointSets& sets, const WindowBodies& all, std::span<const BodyId> bodies)
{
    std::optional<std::size_t> first;
    for (const BodyId body : bodies) {
        const auto found = std::lower_bound(all.list->bodies.begin(), all.list->bodies.end(), body);
        if (found == all.list->bodies.end() || *found != body) continue;
        const auto number = static_cast<std::size_t>(found - all.list->bodies.begin());
        if (all.still[number]) continue;
        if (first) sets.join(*first, number);
        first = number;
    }
}

double energy_taken(const State& state, BodyId body, const BeginAndEnd& velocities, const Vec3& displacement)
{
    return ((velocities.before.squaredNorm() - velocities.after.squaredNorm()) / 2 +
            state.gravity().dot(displacement)) /
           state.inverse_mass(body);
}

}  // namespace carom
