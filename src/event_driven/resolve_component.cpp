#include "event_driven/resolve_component.hpp"

#include "contact/contact_problem.hpp"
#include "event_driven/tolerances.hpp"
#include "heap/heap_windows.hpp"
#include "hold/hold_component.hpp"
#include "hold/rest_policy.hpp"
#include "impact/resolve_cluster.hpp"
#include "math/length.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

namespace carom {

namespace {

class Resolver {
public:
    /// \param key of the event; none for contacts of the start
    Resolver(const State& state, ContactComponent component, const EpochTime& now, std::optional<Key> key,
             EventOutcome& out)
        : state_(state), component_(std::move(component)), now_(now), key_(key), out_(out)
    {
    }

    void go()
    {
        const std::vector<Contact>& contacts = component_.problem.contacts;
        for (const Contact& c : contacts) out_.penetration = std::max(out_.penetration, -c.gap);
        impulses_.assign(contacts.size(), Vec3::Zero());
        const ContactProblem before = component_.problem;
        collide();
        const double speed = std::max(speed_, largest_speed(velocities_before(component_.problem)));
        const HeldContacts held = hold(state_, component_, now_, out_);
        // If the impulse of the event's own contact is less than slow, so are those that balance it.
        double least = state_.tolerances.slow(speed);
        for (std::size_t i = 0; i < contacts.size(); ++i)
            if (is_asked(contacts[i]))
                least = std::min(least, balancing_part * length(impulses_[i] + held.impulses[i] * contacts[i].normal) *
                                            lightness(contacts[i]));
        least = std::max(least, state_.tolerances.impulse * speed);
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const Contact& c = contacts[i];
            Vec3 impulse = Vec3::Zero();
            if (length(impulses_[i]) * lightness(c) > state_.tolerances.impulse * speed) impulse += impulses_[i];
            if (is_asked(c) || std::abs(held.impulses[i]) * lightness(c) > least)
                impulse += held.impulses[i] * c.normal;
            record(c, impulse, held.persists[i]);
        }
        for (const Contact& c : component_.opened) record(c, Vec3::Zero(), false);
        std::stable_partition(out_.events.begin(), out_.events.end(),
                              [](const Event& event) { return event.kind == EventKind::impact; });
        if (key_) drop_what_goes_on(before);
    }

private:
    /// Resolves impacts, if something closes.
    void collide()
    {
        ContactProblem cluster = component_.problem;
        const std::vector<Vec3> before = velocities_before(cluster);
        speed_ = largest_speed(before);
        const auto closes = [&](const Contact& c) { return closing_rate(c, before) < -state_.tolerances.slow(speed_); };
        if (std::none_of(cluster.contacts.begin(), cluster.contacts.end(), closes)) return;

        const bool inelastic = apply_policy(cluster);
        ClusterImpact impact = resolve_cluster(cluster, state_.scene.impact);
        out_.capped = impact.capped;
        if (inelastic || impact.capped)
            (impact.capped ? out_.taken.capped : out_.taken.closing) =
                kinetic_energy(cluster, before) - kinetic_energy(cluster, impact.velocities);
        for (std::size_t k = 0; k < before.size(); ++k) component_.problem.bodies[k].velocity = impact.velocities[k];
        impulses_ = std::move(impact.impulses);
        out_.clustered = std::count_if(impulses_.begin(), impulses_.end(),
                                       [](const Vec3& impulse) { return !impulse.isZero(0); }) > 1;
    }

    /// Restitutions as the rest policy has them (docs/impacts.md, section 4). Policy contact makes e = 0, never where
    /// all e = 1. In heaps: for all contacts if every closing is slower than v_c, otherwise for contacts that closed
    /// less than tau_p ago. In others: for contacts whose bounces rounding ends.
    /// \returns whether something was made inelastic
    bool apply_policy(ContactProblem& cluster)
    {
        const std::vector<Vec3> velocities = velocities_before(cluster);
        if (state_.scene.rest.policy == RestPolicy::micro)
            for (Contact& c : cluster.contacts)
                c.restitution =
                    law_of_impact(state_, state_.law(component_.id_of_a(c), c.partner), -closing_rate(c, velocities))
                        .restitution;
        if (state_.scene.rest.policy != RestPolicy::contact) return false;
        const auto loses = [](const Contact& c) { return c.restitution < 1; };
        if (std::none_of(cluster.contacts.begin(), cluster.contacts.end(), loses)) return false;
        double fastest = 0;
        for (const Contact& c : cluster.contacts) fastest = std::max(fastest, -closing_rate(c, velocities));
        const bool all_slow = fastest < state_.rest.closing_speed;
        bool some = false, rebounds = false;
        for (Contact& c : cluster.contacts) {
            const double closing = -closing_rate(c, velocities);
            const bool ends = component_.is_heap ? all_slow || closed_lately(c) : closing > 0 && rounds(c, closing);
            if (!ends) {
                rebounds = rebounds || (closing > 0 && c.restitution > 0);
            } else if (c.restitution > 0) {
                c.restitution = 0;
                some = true;
            }
        }
        if (some && !rebounds)
            for (Contact& c : cluster.contacts) c.restitution = 0;
        return some;
    }

    bool closed_lately(const Contact& c) const
    {
        return state_.recent.has(component_.id_of_a(c), state_.body_of(c.partner), now_);
    }

    /// Whether rounding ends the bounces of a contact outside heaps, or a threshold, because too many are to come.
    bool rounds(const Contact& c, double closing)
    {
        const BodyId a = component_.id_of_a(c);
        const ContactLaw law{c.restitution, c.tangential, 1};
        if (!is_inelastic(state_, law, a, c.partner, closing, now_, [] { return false; })) return false;
        const double gravity = length(state_.gravity());
        if (!bounces_end(law.restitution) && gravity > 0 && !out_.early_rest)
            out_.early_rest = {a, 2 * law.restitution * closing / (gravity * (1 - law.restitution))};
        return true;
    }

    /// Drops changes of bodies that were only close by: they keep their flights.
    void drop_what_goes_on(const ContactProblem& before)
    {
        std::unordered_set<BodyId> named;
        for (const Event& event : out_.events) named.insert({event.a, event.b});
        std::erase_if(out_.changes, [&](const Change& change) {
            const auto body = std::lower_bound(before.bodies.begin(), before.bodies.end(), change.body,
                                               [](const ContactBody& b, BodyId id) { return b.id < id; });
            return !named.contains(change.body) && goes_on(change, body->velocity);
        });
    }

    bool goes_on(const Change& change, const Vec3& velocity_before) const
    {
        const MotionKind kind = state_.bodies.kind(change.body);
        if (kind != kind_of(change.motion) || velocity_before != change.flight.velocity ||
            state_.flight(change.body).acceleration != change.flight.acceleration)
            return false;
        if (kind == MotionKind::flying) return true;
        const auto* leaning = state_.bodies.as<Leaning>(change.body);
        return leaning && !leaning->rests && !std::get<Leaning>(change.motion).rests &&
               leaning->plane == std::get<Leaning>(change.motion).plane;
    }

    /// Whether it is the contact of the impact that the event is about.
    bool is_asked(const Contact& c) const
    {
        if (!key_ || (key_->kind != Scheduled::pair_impact && key_->kind != Scheduled::plane_impact)) return false;
        const BodyId a = component_.id_of_a(c);
        return (a == key_->a && c.partner == key_->b) ||
               (c.partner == Partner::sphere(key_->a) && key_->b == Partner::sphere(a));
    }

    double lightness(const Contact& c) const
    {
        return state_.inverse_mass(component_.id_of_a(c)) + state_.inverse_mass(c.partner);
    }

    /// Records what happened to a contact: an impulse or none, and that it begins to persist or opens. The impulse of a
    /// contact that opened slowly and was held pulls, which that of no impact does. Contacts of the start neither begin
    /// nor end.
    void record(const Contact& c, const Vec3& impulse, bool persists)
    {
        const bool changes = !impulse.isZero(0);
        const bool pulls = changes && impulse.dot(c.normal) < 0;
        const auto add = [&](EventKind kind, const Vec3& j) {
            out_.events.push_back(make_event(state_, kind, component_.id_of_a(c), c.partner, c.normal, j));
        };
        if (changes) add(pulls ? EventKind::settle : EventKind::impact, impulse);
        if (key_ && persists && !c.persistent) add(EventKind::rest, Vec3::Zero());
        if (key_ && !persists && c.persistent) add(EventKind::release, Vec3::Zero());
    }

    const State& state_;
    ContactComponent component_;
    const EpochTime now_;
    const std::optional<Key> key_;
    EventOutcome& out_;
    double speed_ = 0;            ///< the largest before [length/time]
    std::vector<Vec3> impulses_;  ///< by contact: of the impact [mass length/time]
};

}  // namespace

void resolve_component(const State& state, const Key& key, const Neighbourhood& neighbourhood, EventOutcome& out)
{
    ContactComponent component = gather(state, key, neighbourhood);
    for (const ContactBody& body : component.problem.bodies)
        if (is_in_windows(state, body.id)) {
            out.in_windows = body.id;
            return;
        }
    Resolver(state, std::move(component), key.time, key, out).go();
}

std::vector<EventOutcome> begin_components(const State& state)
{
    std::vector<EventOutcome> out;
    for (ContactComponent& component : declared_components(state)) {
        out.emplace_back();
        Resolver(state, std::move(component), {}, std::nullopt, out.back()).go();
    }
    return out;
}

}  // namespace carom
