#include "hold/guard.hpp"

#include "contact/contact_forces.hpp"
#include "flight/damping.hpp"
#include "motion/height.hpp"
#include "motion/moment.hpp"
#include "stepping/stepping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <span>

namespace carom {

namespace {

bool is_discrete(GuardFallback fallback)
{
    switch (fallback) {
        case GuardFallback::velocity:
        case GuardFallback::pbd:
            return true;
        case GuardFallback::moreau:
        case GuardFallback::windows:
            break;
    }
    return false;
}

class Window {
public:
    Window(const State& state, const EpochTime& now, const Neighbourhood& neighbourhood)
        : state_(state),
          now_(now),
          moment_(state, now),
          neighbourhood_(neighbourhood),
          gravity_(state.gravity()),
          length_(state.scene.guard.window.value_or(state.rest.numeric_step)),
          damped_(state.drag > 0 ? damping(state.drag, length_) : Damping<double>{1, length_, length_ * length_ / 2})
    {
    }

    EventOutcome go(BodyId body)
    {
        collect(body);
        const std::vector<BodyState> end = is_discrete(state_.scene.guard.fallback) ? discrete_step() : moreau_step();
        EventOutcome out;
        out.taken.guard = energy_taken(end);
        out.penetration = depth(end);
        for (std::size_t k = 0; k < end.size(); ++k) out.changes.push_back(straight(k, end[k]));
        out.events.push_back({EventKind::guard, {}, 0, component_.id(0), no_body, Vec3::Zero(), Vec3::Zero()});
        return out;
    }

    std::vector<BodyId> bodies(BodyId body, std::size_t enough)
    {
        collect(body, enough);
        std::vector<BodyId> out;
        for (const ContactBody& member : component_.problem.bodies) out.push_back(member.id);
        return out;
    }

private:
    /// Contacts nearly closed, also those that open, for they may be thrown back within the window, and planes that
    /// would be reached if nothing held; bodies nearly in contact join.
    void collect(BodyId first, std::size_t enough = std::numeric_limits<std::size_t>::max())
    {
        std::map<BodyId, Flight> members{{first, moment_.flight(first)}};
        std::vector<BodyId> frontier{first};
        std::vector<FoundContact> contacts;
        std::set<std::pair<BodyId, BodyId>> found;
        while (!frontier.empty() && members.size() < enough) {
            const BodyId body = frontier.back();
            frontier.pop_back();
            const Flight own = members.at(body);
            for (int p = 0; p < state_.planes(); ++p) {
                const Contact c = plane_contact(state_, body, own, p);
                if (may_close(c, velocity_after(own.velocity, gravity_, damped_), near_contact * state_.radius(body)))
                    contacts.push_back({body, c});
            }
            for (const BodyId other : ascending(neighbourhood_(body))) {
                if (!may_touch(state_, body, own, other, near_contact * state_.radius(body))) continue;
                const auto pair = std::minmax(body, other);
                if (found.contains(pair)) continue;
                const Flight its = moment_.flight(other);
                const double margin = near_contact * std::min(state_.radius(body), state_.radius(other));
                const bool fixed = state_.is_fixed(other);
                const bool ordered = fixed || body < other;
                const Contact c = ordered ? sphere_contact(state_, body, own, other, its)
                                          : sphere_contact(state_, other, its, body, own);
                if (c.gap > margin) continue;
                found.insert(pair);
                contacts.push_back({ordered ? body : other, c});
                if (!fixed && members.emplace(other, its).second) frontier.push_back(other);
            }
        }
        number_bodies(state_, {members.begin(), members.end()}, std::move(contacts), component_);
    }

    /// Bodies in an order that is that of every broad phase: which are looked at first decides the order of contacts,
    /// and what is left out where enough are found.
    static std::vector<BodyId> ascending(std::span<const BodyId> bodies)
    {
        std::vector<BodyId> out(bodies.begin(), bodies.end());
        std::sort(out.begin(), out.end());
        return out;
    }

    bool may_close(const Contact& t, const Vec3& relative, double margin) const
    {
        return t.gap < margin || t.gap + length_ * t.normal.dot(relative) < margin;
    }

    /// The nearest velocities that overlap nowhere at the end of the window, distances taken along normals (spheres
    /// are further apart): 0 <= lambda _|_ c + gap/h >= 0, the same problem as that of forces.
    std::vector<Vec3> without_overlap(const std::vector<Vec3>& velocities) const
    {
        ContactProblem cluster = component_.problem;
        for (std::size_t k = 0; k < velocities.size(); ++k) cluster.bodies[k].velocity = velocities[k];
        std::vector<double> allowed;
        for (const Contact& t : component_.problem.contacts) allowed.push_back(std::max(t.gap, 0.0) / length_);
        return solve_contact_forces(cluster, allowed).accelerations;
    }

    std::vector<BodyState> moreau_step() const
    {
        std::vector<Vec3> free;
        for (const Flight& f : component_.flights) free.push_back(velocity_after(f.velocity, gravity_, damped_));
        const std::vector<Vec3> after = without_overlap(free);
        std::vector<BodyState> out;
        for (std::size_t k = 0; k < after.size(); ++k) out.push_back({length_ * after[k], after[k], Mode::numeric});
        return out;
    }

    /// A scene of the members, and of what they could meet, in one step of another method; overlaps that it leaves end
    /// with the window, for the engine knows none. \returns displacements and velocities
    std::vector<BodyState> discrete_step() const
    {
        const Place& centre = component_.flights.front().place;
        const auto at = [&](const Place& place) { return separation(state_.frame, place, centre); };
        Scene scene;  // of what matters here: a copy would bring all spheres
        scene.gravity = state_.scene.gravity;
        scene.drag = state_.drag;
        scene.materials = state_.scene.materials;
        scene.contacts = state_.scene.contacts;
        scene.planes = state_.scene.planes;
        for (std::size_t k = 0; k < component_.flights.size(); ++k) {
            scene.spheres.push_back(state_.sphere(component_.id(k)));
            scene.spheres.back().position = at(component_.flights[k].place);
            scene.spheres.back().velocity = component_.flights[k].velocity;
        }
        std::set<BodyId> fixed;
        for (const Contact& t : component_.problem.contacts)
            if (state_.is_fixed(t.partner) && fixed.insert(t.partner.index).second) {
                scene.spheres.push_back(state_.sphere(t.partner.index));
                scene.spheres.back().position = at(state_.flight(t.partner.index).place);
            }
        for (Plane& plane : scene.planes) plane.offset = -signed_height(state_.frame, plane, centre).high;
        scene.end_time = length_;
        StepOptions options;
        options.dt = length_;
        // Drag in the free motion's closed form: the semi-implicit one is unstable in windows longer than 2 / drag.
        if (state_.drag > 0) options.integrator = Integrator::parabola;
        const Outcome step = state_.scene.guard.fallback == GuardFallback::pbd
                                 ? run_stepping(scene, PositionBased{{options}}, {}, {})
                                 : run_stepping(scene, VelocityBased{{options}}, {}, {});
        std::vector<Vec3> mean;
        for (std::size_t k = 0; k < component_.flights.size(); ++k)
            mean.push_back((step.final[k].position - scene.spheres[k].position) / length_);
        mean = without_overlap(mean);
        std::vector<BodyState> out;
        for (std::size_t k = 0; k < mean.size(); ++k)
            out.push_back({length_ * mean[k], step.final[k].velocity, Mode::numeric});
        return out;
    }

    /// Overlap at the end of the window, as linear prediction has it: an upper bound.
    double depth(const std::vector<BodyState>& end) const
    {
        double deepest = 0;
        for (const Contact& t : component_.problem.contacts) {
            const Vec3 shift_a = end[static_cast<std::size_t>(t.a)].position;
            const Vec3 shift_b = t.b ? end[static_cast<std::size_t>(*t.b)].position : Vec3(Vec3::Zero());
            deepest = std::max(deepest, -(t.gap + t.normal.dot(shift_a - shift_b)));
        }
        return deepest;
    }

    /// What drag takes of the straight flights that stand for the window is its work, and no part of this.
    double energy_taken(const std::vector<BodyState>& end) const
    {
        double taken = 0;
        for (std::size_t k = 0; k < end.size(); ++k) {
            const Vec3& before = component_.flights[k].velocity;
            const double dragged = (1 - damped_.decay * damped_.decay) * start_velocity(end[k]).squaredNorm() / 2;
            taken +=
                ((before.squaredNorm() - end[k].velocity.squaredNorm()) / 2 + gravity_.dot(end[k].position) - dragged) /
                component_.problem.bodies[k].inverse_mass;
        }
        return taken;
    }

    /// The velocity with which a body's straight flight begins, damped or not.
    Vec3 start_velocity(const BodyState& end) const { return end.position / damped_.way; }

    Change straight(std::size_t k, const BodyState& end) const
    {
        Change out{component_.id(k), component_.flights[k], Windowed{state_.frame.after(now_, length_), end.velocity}};
        out.flight.start = now_;
        out.flight.velocity = start_velocity(end);
        out.flight.acceleration = Accelerations::none;
        for (const Contact& t : component_.problem.contacts) {
            const BodyId a = component_.id_of_a(t);
            if (a == out.body) out.contacts.push_back({t.partner, 0});
            if (t.partner == Partner::sphere(out.body)) out.contacts.push_back({Partner::sphere(a), 0});
        }
        return out;
    }

    const State& state_;
    const EpochTime now_;
    Moment moment_;
    const Neighbourhood& neighbourhood_;
    const Vec3 gravity_;
    const double length_;           ///< of the window, h [time]
    const Damping<double> damped_;  ///< what the window does to velocities and ways
    ContactComponent component_;
};

}  // namespace

EventOutcome guard(const State& state, BodyId body, const EpochTime& now, const Neighbourhood& neighbourhood)
{
    return Window(state, now, neighbourhood).go(body);
}

std::vector<BodyId> guarded_bodies(const State& state, BodyId body, const EpochTime& now,
                                   const Neighbourhood& neighbourhood, std::size_t enough)
{
    return Window(state, now, neighbourhood).bodies(body, enough);
}

}  // namespace carom
