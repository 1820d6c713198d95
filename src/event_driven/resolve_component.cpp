#include "event_driven/resolve_component.hpp"

#include "contact/contact_problem.hpp"
#include "event_driven/support.hpp"
#include "impact/resolve_cluster.hpp"
#include "math/length.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace carom {

namespace {

/// Of the largest speed: impulses that change speeds by less are what rounding leaves of none.
constexpr double rounding = 1e-13;

std::vector<Vec3> velocities_of(const ContactComponent& component)
{
    std::vector<Vec3> out;
    for (const Flight& f : component.flights) out.push_back(f.velocity);
    return out;
}

/// Restitution as the rest policy has it. Policy contact: e := 0: for all contacts if every closing is slower than v_c,
/// otherwise for those that closed a moment ago. Never where all e = 1. \returns whether something was made inelastic
bool apply_policy(const State& state, const ContactComponent& component, const EpochTime& now, ContactProblem& cluster)
{
    const std::vector<Vec3> velocities = velocities_before(cluster);
    if (state.scene.rest.policy == RestPolicy::micro)
        for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
            const Touch& t = component.contacts[i];
            const double closing = -closing_rate(cluster.contacts[i], velocities);
            cluster.contacts[i].restitution = law_of_impact(state, state.law(t.a, t.b), closing).restitution;
        }
    if (state.scene.rest.policy != RestPolicy::contact) return false;
    const auto loses = [](const Contact& c) { return c.restitution < 1; };
    if (std::none_of(cluster.contacts.begin(), cluster.contacts.end(), loses)) return false;
    double fastest = 0;
    for (const Contact& c : cluster.contacts) fastest = std::max(fastest, -closing_rate(c, velocities));
    bool some = false;
    for (std::size_t i = 0; i < cluster.contacts.size(); ++i) {
        Contact& c = cluster.contacts[i];
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

    /// \param key of the event, null for contacts of the start
    ComponentResolution go(const Key* key)
    {
        const bool started = key == nullptr;
        for (const Touch& t : component_.contacts) out_.penetration = std::max(out_.penetration, -t.gap);
        impulses_.assign(component_.contacts.size(), Vec3::Zero());
        const std::vector<Flight> before = component_.flights;
        collide();
        const std::vector<Touch> contacts = component_.contacts, opened = component_.opened;
        const double speed = std::max(speed_, largest_speed(velocities_of(component_)));
        HeldComponent held = hold(state_, std::move(component_), now_);
        const auto is_asked = [&](const Touch& t) { return key != nullptr && is_impact(*key) && is_of(t, *key); };
        // Where what is asked for is less than slow, so is what balances it.
        double least = slow(speed);
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (is_asked(contacts[i]))
                least = std::min(least, 1e-3 * length(impulses_[i] + held.impulses[i] * contacts[i].normal) *
                                            lightness(contacts[i]));
        least = std::max(least, rounding * speed);
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Touch& t = contacts[i];
            Vec3 impulse = Vec3::Zero();
            if (length(impulses_[i]) * lightness(t) > rounding * speed) impulse += impulses_[i];
            if (is_asked(t) || std::abs(held.impulses[i]) * lightness(t) > least)
                impulse += held.impulses[i] * t.normal;
            report(t, impulse, held.persists[i], started);
        }
        for (const Touch& t : opened) report(t, Vec3::Zero(), false, started);
        std::stable_partition(out_.events.begin(), out_.events.end(),
                              [](const Event& event) { return event.kind == EventKind::impact; });
        drop_what_goes_on(before, held.changes, key);
        out_.changes = std::move(held.changes);
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
        ContactProblem cluster = cluster_of(state_, component_);
        const std::vector<Vec3> before = velocities_before(cluster);
        speed_ = largest_speed(before);
        const auto closes = [&](const Contact& c) { return closing_rate(c, before) < -slow(speed_); };
        if (std::none_of(cluster.contacts.begin(), cluster.contacts.end(), closes)) return;

        const bool inelastic = apply_policy(state_, component_, now_, cluster);
        ClusterImpact impact = resolve_cluster(cluster, state_.scene.impact);
        out_.capped = impact.capped;
        if (inelastic || impact.capped)
            (impact.capped ? out_.taken.capped : out_.taken.closing) =
                kinetic_energy(cluster, before) - kinetic_energy(cluster, impact.velocities);
        for (std::size_t k = 0; k < component_.flights.size(); ++k)
            component_.flights[k].velocity = impact.velocities[k];
        impulses_ = std::move(impact.impulses);
        out_.clustered = std::count_if(impulses_.begin(), impulses_.end(),
                                       [](const Vec3& impulse) { return !impulse.isZero(0); }) > 1;
    }

    /// Bodies that were close by only keep their flights. Of those whose event it is one at least does not, so that it
    /// does not come again.
    void drop_what_goes_on(const std::vector<Flight>& before, std::vector<MemberChange>& changes, const Key* key) const
    {
        if (key == nullptr) return;
        std::unordered_set<BodyId> named;
        for (const Event& event : out_.events) named.insert({event.a, event.b});
        std::vector<char> drops;
        int of_key = 0, dropped_of_key = 0;
        const auto is_of_key = [&](const MemberChange& c) { return c.body == key->a || c.body == key->b; };
        for (std::size_t k = 0; k < before.size(); ++k) {
            drops.push_back(!named.contains(changes[k].body) && goes_on(changes[k], before[k]));
            if (!is_of_key(changes[k])) continue;
            ++of_key;
            dropped_of_key += drops[k];
        }
        std::size_t k = 0;
        const bool all = of_key == dropped_of_key;
        std::erase_if(changes, [&](const MemberChange& c) { return drops[k++] && !(all && is_of_key(c)); });
    }

    bool goes_on(const MemberChange& change, const Flight& before) const
    {
        const Flight &old = state_.flight(change.body), &next = change.flight;
        const bool simple = old.support != several_supports && (old.mode == Mode::flying || old.mode == Mode::sliding);
        return simple && old.mode == next.mode && old.support == next.support &&
               old.acceleration == next.acceleration && before.velocity == next.velocity;
    }

    static bool is_impact(const Key& key)
    {
        return key.kind == Scheduled::pair_impact || key.kind == Scheduled::plane_impact;
    }
    static bool is_of(const Touch& t, const Key& key)
    {
        return (t.a == key.a && t.b == key.b) || (t.a == key.b && t.b == key.a);
    }

    /// Slower is as good as not at all, where contacts persist.
    double slow(double speed) const { return std::max(1e-6 * state_.rest.closing_speed, 1e-12 * speed); }

    double lightness(const Touch& t) const
    {
        return state_.inverse_mass(t.a) + (state_.is_plane(t.b) ? 0 : state_.inverse_mass(t.b));
    }

    /// What happened to a contact: an impulse, or none; that it begins to persist, or opens. A contact that opened
    /// slowly and was held is pulled, which no impact does.
    void report(const Touch& t, const Vec3& impulse, bool persists, bool started)
    {
        const bool changes = !impulse.isZero(0);
        const bool pulls = changes && impulse.dot(t.normal) < 0;
        const Vec3 none = Vec3::Zero();
        const auto add = [&](EventKind kind, const Vec3& j) { out_.events.push_back(event_between(kind, t, j)); };
        if (changes && !pulls) add(EventKind::impact, impulse);
        if (pulls) add(EventKind::settle, impulse);
        if (persists && !t.persistent && !started) add(EventKind::rest, none);
        if (!persists && t.persistent && !started) add(EventKind::release, none);
    }

    const State& state_;
    ContactComponent component_;
    const EpochTime now_;
    double speed_ = 0;            ///< the largest before [length/time]
    std::vector<Vec3> impulses_;  ///< by contact: of the impact [mass length/time]
    ComponentResolution out_;
};

}  // namespace

ComponentResolution resolve_component(const State& state, const Key& key, const Neighbourhood& neighbourhood)
{
    return Resolver(state, gather(state, key, neighbourhood), key.time).go(&key);
}

std::vector<ComponentResolution> begin_components(const State& state)
{
    std::vector<ComponentResolution> out;
    for (ContactComponent& component : declared_components(state))
        out.push_back(Resolver(state, std::move(component), {}).go(nullptr));
    return out;
}

}  // namespace carom
