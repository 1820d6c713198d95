#include "event_driven/component.hpp"

#include "event_driven/may_touch.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/piece.hpp"
#include "event_driven/simultaneous.hpp"
#include "math/disjoint_sets.hpp"
#include "scene/pair_gap.hpp"
#include "scene/sphere_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_set>

namespace carom {

namespace {

double smaller_radius(const State& state, BodyId a, BodyId b)
{
    return state.is_plane(b) ? state.radius(a) : std::min(state.radius(a), state.radius(b));
}

bool comes_first(const Touch& x, const Touch& y)
{
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
}

/// Walks along closed contacts, from body to body.
class Walk {
public:
    Walk(const State& state, const Key& key, const Neighbourhood& neighbourhood)
        : state_(state), key_(key), instant_(state, key), moment_(state, key.time), neighbourhood_(neighbourhood)
    {
        const bool impact = key.kind == Scheduled::pair_impact || key.kind == Scheduled::plane_impact;
        ties_ = impact;
    }

    ContactComponent go()
    {
        if (ties_) found_.insert(pair(key_.a, key_.b));
        enter(key_.a);
        if (!state_.is_plane(key_.b)) enter(key_.b);
        while (!frontier_.empty()) {
            const BodyId body = frontier_.back();
            frontier_.pop_back();
            look_around(body);
        }
        ContactComponent out;
        for (const auto& [body, flight] : members_) {
            out.bodies.push_back(body);
            out.flights.push_back(flight);
        }
        for (const auto& [a, b] : found_) out.contacts.push_back(closed(a, b));
        std::sort(out.contacts.begin(), out.contacts.end(), comes_first);
        for (const auto& [which, contact] : opened_) out.opened.push_back(contact);
        return out;
    }

private:
    using Pair = std::pair<BodyId, BodyId>;

    Pair pair(BodyId a, BodyId b) const
    {
        if (state_.is_plane(b)) return {a, b};
        if (state_.is_fixed(b)) return {a, b};
        if (state_.is_fixed(a)) return {b, a};
        return {std::min(a, b), std::max(a, b)};
    }

    void enter(BodyId body)
    {
        if (state_.is_fixed(body) || members_.contains(body)) return;
        members_.emplace(body, moment_.flight(body));
        frontier_.push_back(body);
    }

    const Flight& flight(BodyId body)
    {
        const auto member = members_.find(body);
        if (member != members_.end()) return member->second;
        const auto other = others_.find(body);
        if (other != others_.end()) return other->second;
        return others_.emplace(body, moment_.flight(body)).first->second;
    }

    Touch closed(BodyId a, BodyId b)
    {
        Touch out = touch(state_, a, flight(a), b, state_.is_plane(b) ? nullptr : &flight(b));
        out.persistent = (state_.contacts.between(a, b) && !is_guarded(a) && !is_guarded(b)) ||
                         (state_.is_plane(b) && state_.flight(a).mode != Mode::series &&
                          state_.flight(a).support == state_.plane_index(b));
        return out;
    }

    /// A window lists whom it may push, and none of that persists.
    bool is_guarded(BodyId body) const
    {
        return !state_.is_plane(body) && state_.flight(body).mode == Mode::numeric && !state_.pieces.at(body).cluster;
    }

    void take(BodyId body, BodyId other)
    {
        if (found_.insert(pair(body, other)).second && !state_.is_plane(other)) enter(other);
    }

    void look_around(BodyId body)
    {
        const Flight& own = state_.flight(body);
        if (own.mode != Mode::series && own.support >= 0)
            take(body, state_.scene.plane_body(static_cast<std::size_t>(own.support)));
        for (const PersistentContact& c : state_.contacts.of(body)) {
            const auto [a, b] = pair(body, c.partner);
            const Touch t = closed(a, b);
            if (t.gap <= persistence_gap(state_, body, c.partner)) {
                take(body, c.partner);
            } else if (!found_.contains({a, b}) && opened_.try_emplace({a, b}, t).second &&
                       !state_.is_plane(c.partner)) {
                enter(c.partner);
            }
        }
        if (!ties_) return;
        for (std::size_t p = 0; p < state_.scene.planes.size(); ++p) take_tie(body, state_.scene.plane_body(p));
        near_.clear();
        const Flight& now = flight(body);
        const double margin = std::max(state_.rebound_gap, state_.tie(state_.radius(body)));
        for (const BodyId other : neighbourhood_(body))
            if (may_touch(state_, body, now, other, margin)) near_.push_back(other);
        for (const BodyId other : near_) take_tie(body, other);
    }

    void take_tie(BodyId body, BodyId other)
    {
        const auto [a, b] = pair(body, other);
        if (found_.contains({a, b})) return;
        if (!state_.ties(a, b, closed(a, b).gap, key_.time) || !instant_.is_that_of(a, b)) return;
        opened_.erase({a, b});  // open, but not so far
        take(body, other);
    }

    struct PairHash {
        std::size_t operator()(const Pair& p) const
        {
            return std::hash<std::uint64_t>()((static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.first)) << 32) |
                                              static_cast<std::uint32_t>(p.second));
        }
    };

    const State& state_;
    const Key& key_;
    ContactInstant instant_;
    Moment moment_;
    const Neighbourhood& neighbourhood_;
    bool ties_ = false;  ///< contacts may close at this very instant
    std::map<BodyId, Flight> members_;
    std::unordered_map<BodyId, Flight> others_;
    std::unordered_set<Pair, PairHash> found_;
    std::map<Pair, Touch> opened_;
    std::vector<BodyId> frontier_, near_;
};

/// Every contact that the scene declares.
std::vector<Touch> declared_contacts(const State& state)
{
    std::vector<Touch> found;
    for (BodyId a = 0; a < state.count(); ++a) {
        if (state.is_fixed(a)) continue;
        for (std::size_t p = 0; p < state.scene.planes.size(); ++p) {
            const Touch t = touch(state, a, state.flight(a), state.scene.plane_body(p), nullptr);
            if (std::abs(t.gap) <= declared_contact * state.radius(a)) found.push_back(t);
        }
    }
    SphereGrid grid;
    for (const std::size_t i : largest_first(state.radii)) {
        const auto own = static_cast<BodyId>(i);
        grid.visit_near(state.scene.spheres[i].position, state.radii[i], [&](std::size_t j) {
            auto a = std::min(own, static_cast<BodyId>(j)), b = std::max(own, static_cast<BodyId>(j));
            if (state.is_fixed(a) && state.is_fixed(b)) return true;
            if (state.is_fixed(a)) std::swap(a, b);
            const Touch t = touch(state, a, state.flight(a), b, &state.flight(b));
            if (std::abs(t.gap) <= declared_contact * smaller_radius(state, a, b)) found.push_back(t);
            return true;
        });
        grid.insert(i, state.scene.spheres[i].position, state.radii[i]);
    }
    for (Touch& t : found) t.persistent = true;
    std::sort(found.begin(), found.end(), comes_first);
    return found;
}

}  // namespace

std::optional<int> ContactComponent::index_of(BodyId body) const
{
    const auto found = std::lower_bound(bodies.begin(), bodies.end(), body);
    return found == bodies.end() || *found != body ? immovable
                                                   : std::optional(static_cast<int>(found - bodies.begin()));
}

double persistence_gap(const State& state, BodyId a, BodyId b)
{
    return std::max(state.rest.gap_tolerance, declared_contact * smaller_radius(state, a, b));
}

ContactComponent gather(const State& state, const Key& contact, const Neighbourhood& neighbourhood)
{
    return Walk(state, contact, neighbourhood).go();
}

std::vector<ContactComponent> declared_components(const State& state)
{
    const std::vector<Touch> contacts = declared_contacts(state);
    if (contacts.empty()) return {};
    DisjointSets sets(static_cast<std::size_t>(state.count()));
    for (const Touch& t : contacts)
        if (!state.is_plane(t.b) && !state.is_fixed(t.b))
            sets.join(static_cast<std::size_t>(t.a), static_cast<std::size_t>(t.b));
    std::map<std::size_t, ContactComponent> found;  // by their smallest bodies
    for (const Touch& t : contacts) found[sets.smallest(static_cast<std::size_t>(t.a))].contacts.push_back(t);
    for (BodyId i = 0; i < state.count(); ++i) {
        const auto its = found.find(sets.smallest(static_cast<std::size_t>(i)));
        if (its == found.end() || state.is_fixed(i)) continue;
        its->second.bodies.push_back(i);
        its->second.flights.push_back(state.flight(i));
    }
    std::vector<ContactComponent> out;
    for (auto& [smallest, component] : found) {
        const bool alone = component.contacts.size() == 1 && state.is_plane(component.contacts.front().b);
        if (!alone) out.push_back(std::move(component));
    }
    return out;
}

Touch touch(const State& state, BodyId a, const Flight& fa, BodyId b, const Flight* fb)
{
    Touch out{a, b, Vec3::Zero(), 0, false};
    if (state.is_plane(b)) {
        const int p = state.plane_index(b);
        out.normal = facing_normal(state, p, fa.place);
        out.gap = height_above(state, a, p, fa.place);
        return out;
    }
    const Vec3 r = separation(state.frame, fa.place, fb->place);
    const double distance = std::sqrt(r.squaredNorm());
    out.normal = r / distance;
    out.gap = distance - (state.radius(a) + state.radius(b));
    return out;
}

Event event_between(EventKind kind, const Touch& t, const Vec3& impulse)
{
    if (t.a < t.b) return {kind, {}, 0, t.a, t.b, t.normal, impulse};
    return {kind, {}, 0, t.b, t.a, -t.normal, -impulse};
}

ContactProblem cluster_of(const State& state, const ContactComponent& component)
{
    ContactProblem out;
    for (std::size_t i = 0; i < component.bodies.size(); ++i)
        out.bodies.push_back({component.flights[i].velocity, state.inverse_mass(component.bodies[i])});
    for (const Touch& t : component.contacts) {
        const ContactLaw& law = state.law(t.a, t.b);
        out.contacts.push_back(
            {*component.index_of(t.a), component.index_of(t.b), t.normal, law.restitution, law.tangential});
    }
    return out;
}

}  // namespace carom
