#include "event_driven/resolve_component.hpp"

#include "event_driven/support.hpp"
#include "impact/resolve_cluster.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace carom {

namespace {

std::vector<Vec3> velocities_of(const Cluster& cluster)
{
    std::vector<Vec3> out;
    for (const ClusterBody& body : cluster.bodies) out.push_back(body.velocity);
    return out;
}

double kinetic_energy(const Cluster& cluster, const std::vector<Vec3>& velocities)
{
    double sum = 0;
    for (std::size_t k = 0; k < velocities.size(); ++k)
        sum += velocities[k].squaredNorm() / 2 / cluster.bodies[k].inverse_mass;
    return sum;
}

/// Restitution as the rest policy has it. Policy contact: e := 0: for all contacts if every closing is slower than v_c,
/// otherwise for those that closed a moment ago. Never where all e = 1. \returns whether something was made inelastic
bool apply_policy(const State& state, const ContactComponent& component, const EpochTime& now, Cluster& cluster)
{
    const std::vector<Vec3> velocities = velocities_of(cluster);
    if (state.scene.rest.policy == RestPolicy::micro)
        for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
            const Touch& t = component.contacts[i];
            const double closing = -closing_rate(cluster.contacts[i], velocities);
            cluster.contacts[i].restitution = law_of_impact(state, t.a, t.b, closing).restitution;
        }
    if (state.scene.rest.policy != RestPolicy::contact) return false;
    const auto loses = [](const ClusterContact& c) { return c.restitution < 1; };
    if (std::none_of(cluster.contacts.begin(), cluster.contacts.end(), loses)) return false;
    double fastest = 0;
    for (const ClusterContact& c : cluster.contacts) fastest = std::max(fastest, -closing_rate(c, velocities));
    bool some = false;
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
        ClusterContact& c = cluster.contacts[i];
        const Touch& t = component.contacts[i];
        if (!(c.restitution > 0) || (fastest >= state.rest.closing_speed && !state.recent.has(t.a, t.b, now))) continue;
        c.restitution = 0;
        some = true;
    }
    return some;
}

class Resolver {
public:
    Resolver(const State& state, ContactComponent component, const EpochTime& now)
        : state_(state), component_(std::move(component)), now_(now)
    {
    }

    ComponentResolution go(bool started)
    {
        for (const Touch& t : component_.contacts) out_.penetration = std::max(out_.penetration, -t.gap);
        collide();
        HeldComponent held = hold(state_, std::move(component_), now_, started);
        out_.changes = std::move(held.changes);
        add(held.events);
        out_.taken.settling = held.taken.settling;
        out_.taken.stabilising = held.taken.stabilising;
        out_.numeric_steps = held.numeric_steps;
        out_.penetration = std::max(out_.penetration, held.depth);
        return std::move(out_);
    }

private:
    /// Impacts, if something closes.
    void collide()
    {
        Cluster cluster = cluster_of(state_, component_);
        const std::vector<Vec3> before = velocities_of(cluster);
        double speed = 0;
        for (const Vec3& v : before) speed = std::max(speed, v.squaredNorm());
        const double slack = std::max(1e-6 * state_.rest.closing_speed, 1e-12 * std::sqrt(speed));
        const auto closes = [&](const ClusterContact& c) { return closing_rate(c, before) < -slack; };
        if (std::none_of(cluster.contacts.begin(), cluster.contacts.end(), closes)) return;

        const bool inelastic = apply_policy(state_, component_, now_, cluster);
        const ClusterImpact impact = resolve_cluster(cluster, state_.scene.impact);
        if (inelastic)
            out_.taken.closing = kinetic_energy(cluster, before) - kinetic_energy(cluster, impact.velocities);
        for (std::size_t k = 0; k < component_.flights.size(); ++k)
            component_.flights[k].velocity = impact.velocities[k];
        report(impact);
    }

    /// One impact a contact and instant.
    void add(const std::vector<Event>& events)
    {
        std::map<std::pair<BodyId, BodyId>, std::size_t> impacts;
        for (std::size_t i = 0; i < out_.events.size(); ++i) impacts[{out_.events[i].a, out_.events[i].b}] = i;
        for (const Event& event : events) {
            const auto known = impacts.find({event.a, event.b});
            if (event.kind == EventKind::impact && known != impacts.end())
                out_.events[known->second].impulse += event.impulse;
            else
                out_.events.push_back(event);
        }
    }

    /// An event for each contact that got an impulse, beyond what rounding gives to those that got none.
    void report(const ClusterImpact& impact)
    {
        double largest = 0;
        for (const Vec3& impulse : impact.impulses) largest = std::max(largest, impulse.squaredNorm());
        int some = 0;
        for (std::size_t i = 0; i < impact.impulses.size(); ++i) {
            constexpr double rounding = 1e-24;  // of squares
            if (!(impact.impulses[i].squaredNorm() > rounding * largest)) continue;
            out_.events.push_back(event_between(EventKind::impact, component_.contacts[i], impact.impulses[i]));
            ++some;
        }
        out_.clustered = some > 1;
    }

    const State& state_;
    ContactComponent component_;
    const EpochTime now_;
    ComponentResolution out_;
};

}  // namespace

ContactLaw law_of_impact(const State& state, BodyId a, BodyId b, double closing)
{
    ContactLaw law = state.law(a, b);
    if (state.scene.rest.policy == RestPolicy::micro && closing < state.rest.closing_speed) law.restitution = 1;
    return law;
}

bool is_inelastic(const State& state, BodyId a, BodyId b, double closing, const EpochTime& now)
{
    return state.scene.rest.policy == RestPolicy::contact && state.law(a, b).restitution < 1 &&
           (closing < state.rest.closing_speed || state.recent.has(a, b, now));
}

ComponentResolution resolve_component(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    return Resolver(state, gather(state, key, neighbourhood), key.time).go(false);
}

std::vector<ComponentResolution> begin_components(const State& state)
{
    std::vector<ComponentResolution> out;
    for (ContactComponent& component : declared_components(state))
        out.push_back(Resolver(state, std::move(component), {}).go(true));
    return out;
}

}  // namespace carom
