#include "gather/component.hpp"

#include "gather/instant.hpp"
#include "math/disjoint_sets.hpp"
#include "motion/height.hpp"
#include "motion/moment.hpp"
#include "scene/pair_gap.hpp"
#include "scene/sphere_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_set>

namespace carom {

namespace {

/// A contact with the law of its materials.
Contact lawful(const State& state, BodyId a, Partner b, const Vec3& normal, double gap)
{
    const ContactLaw& law = state.law(a, b);
    return {.normal = normal, .restitution = law.restitution, .tangential = law.tangential, .partner = b, .gap = gap};
}

bool comes_first(const FoundContact& x, const FoundContact& y)
{
    return std::tie(x.a, x.contact.partner) < std::tie(y.a, y.contact.partner);
}

/// Walks along closed contacts, from body to body.
class Walk {
public:
    Walk(const State& state, const Key& key, const Neighbourhood& neighbourhood)
        : state_(state),
          key_(key),
          instant_(state, key, neighbourhood),
          moment_(state, key.time),
          neighbourhood_(neighbourhood),
          ties_(key.kind == Scheduled::pair_impact || key.kind == Scheduled::plane_impact)
    {
    }

    ContactComponent go()
    {
        if (ties_) found_.insert(pair(key_.a, key_.b));
        enter(key_.a);
        if (key_.b.is_sphere()) enter(key_.b.index);
        while (!frontier_.empty()) {
            const BodyId body = frontier_.back();
            frontier_.pop_back();
            look_around(body);
        }
        std::vector<FoundContact> contacts;
        for (const auto& [a, b] : found_) contacts.push_back({a, closed(a, b)});
        std::sort(contacts.begin(), contacts.end(), comes_first);
        ContactComponent out;
        number_bodies(state_, {members_.begin(), members_.end()}, std::move(contacts), out);
        out.is_heap = state_.loses_energy && (members_.size() > largest_group || instant_.is_in_heap());
        for (const auto& [which, contact] : opened_) {
            out.opened.push_back(contact);
            out.opened.back().a = static_cast<int>(std::distance(members_.begin(), members_.find(which.first)));
        }
        return out;
    }

private:
    using Pair = std::pair<BodyId, Partner>;

    Pair pair(BodyId a, Partner b) const
    {
        if (b.is_plane() || state_.is_fixed(b)) return {a, b};
        if (state_.is_fixed(a)) return {b.index, Partner::sphere(a)};
        return {std::min(a, b.index), Partner::sphere(std::max(a, b.index))};
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

    Contact closed(BodyId a, Partner b)
    {
        Contact out = b.is_plane() ? plane_contact(state_, a, flight(a), b.index)
                                   : sphere_contact(state_, a, flight(a), b.index, flight(b.index));
        const auto* leaning = state_.bodies.as<Leaning>(a);
        out.persistent =
            (state_.bodies.contacts().between(a, b) && !is_guarded(a) && !(b.is_sphere() && is_guarded(b.index))) ||
            (leaning && b == Partner::plane(leaning->plane));
        return out;
    }

    /// Whether the body is in a window of the guard: its listed contacts are those that the window may push, and none
    /// of them persists.
    bool is_guarded(BodyId body) const { return state_.bodies.kind(body) == MotionKind::windowed; }

    void take(BodyId body, Partner other)
    {
        if (found_.insert(pair(body, other)).second && other.is_sphere()) enter(other.index);
    }

    void look_around(BodyId body)
    {
        if (const auto* leaning = state_.bodies.as<Leaning>(body)) take(body, Partner::plane(leaning->plane));
        for (const PersistentContact& c : state_.bodies.contacts().of(body)) {
            const auto [a, b] = pair(body, c.partner);
            const Contact contact = closed(a, b);
            if (contact.gap <= persistence_gap(state_, body, c.partner)) {
                take(body, c.partner);
            } else if (!found_.contains({a, b}) && opened_.try_emplace({a, b}, contact).second &&
                       c.partner.is_sphere()) {
                enter(c.partner.index);
            }
        }
        if (!ties_) return;
        for (int p = 0; p < state_.planes(); ++p) take_tie(body, Partner::plane(p));
        const Flight& now = flight(body);
        const double margin = state_.widest_tie(body);
        const std::span<const BodyId> near = neighbourhood_(body);
        for (const BodyId other : std::vector<BodyId>(near.begin(), near.end()))  // ties ask for others'
            if (may_touch(state_, body, now, other, margin)) take_tie(body, Partner::sphere(other));
    }

    void take_tie(BodyId body, Partner other)
    {
        const auto [a, b] = pair(body, other);
        if (found_.contains({a, b})) return;
        if (!instant_.ties(a, b, closed(a, b).gap) || !instant_.is_that_of(a, b)) return;
        opened_.erase({a, b});  // open, but not so far
        take(body, other);
    }

    struct PairHash {
        std::size_t operator()(const Pair& p) const
        {
            const auto low = static_cast<std::uint32_t>(p.second.index) * 2 + (p.second.is_plane() ? 1u : 0u);
            return std::hash<std::uint64_t>()((static_cast<std::uint64_t>(static_cast<std::uint32_t>(p.first)) << 32) |
                                              low);
        }
    };

    const State& state_;
    const Key& key_;
    ContactInstant instant_;
    Moment moment_;
    const Neighbourhood& neighbourhood_;
    const bool ties_;  ///< contacts may close at this very instant
    std::map<BodyId, Flight> members_;
    std::unordered_map<BodyId, Flight> others_;
    std::unordered_set<Pair, PairHash> found_;
    std::map<Pair, Contact> opened_;
    std::vector<BodyId> frontier_;
};

/// Every contact that the scene declares, by its first body.
std::vector<FoundContact> declared_contacts(const State& state)
{
    std::vector<FoundContact> found;
    const auto look = [&](BodyId a, const Contact& contact) {
        if (std::abs(contact.gap) <= declared_contact * state.smaller_radius(a, contact.partner))
            found.push_back({a, contact});
    };
    for (BodyId a = 0; a < state.count(); ++a)
        for (int p = 0; p < state.planes() && !state.is_fixed(a); ++p)
            look(a, plane_contact(state, a, state.flight(a), p));
    std::vector<double> radii;
    for (const Sphere& s : state.scene.spheres) radii.push_back(s.radius);
    SphereGrid grid;
    for (const std::size_t i : largest_first(radii)) {
        const auto own = static_cast<BodyId>(i);
        grid.visit_near(state.scene.spheres[i].position, radii[i], [&](std::size_t j) {
            auto a = std::min(own, static_cast<BodyId>(j)), b = std::max(own, static_cast<BodyId>(j));
            if (state.is_fixed(a) && state.is_fixed(b)) return true;
            if (state.is_fixed(a)) std::swap(a, b);
            look(a, sphere_contact(state, a, state.flight(a), b, state.flight(b)));
            return true;
        });
        grid.insert(i, state.scene.spheres[i].position, radii[i]);
    }
    for (FoundContact& f : found) f.contact.persistent = true;
    std::sort(found.begin(), found.end(), comes_first);
    return found;
}

}  // namespace

void number_bodies(const State& state, const std::vector<std::pair<BodyId, Flight>>& bodies,
                   std::vector<FoundContact> contacts, ContactComponent& out)
{
    for (const auto& [id, flight] : bodies) {
        out.problem.bodies.push_back({flight.velocity, state.inverse_mass(id), id});
        out.flights.push_back(flight);
    }
    const auto number = [&](BodyId id) {
        const auto found = std::lower_bound(out.problem.bodies.begin(), out.problem.bodies.end(), id,
                                            [](const ContactBody& body, BodyId wanted) { return body.id < wanted; });
        return static_cast<int>(found - out.problem.bodies.begin());
    };
    for (FoundContact& found : contacts) {
        found.contact.a = number(found.a);
        if (state.is_movable(found.contact.partner)) found.contact.b = number(found.contact.partner.index);
        out.problem.contacts.push_back(found.contact);
    }
}

double persistence_gap(const State& state, BodyId a, Partner b)
{
    return state.tolerances.closed(state.smaller_radius(a, b));
}

ContactComponent gather(const State& state, const Key& contact, const Neighbourhood& neighbourhood)
{
    return Walk(state, contact, neighbourhood).go();
}

std::vector<ContactComponent> declared_components(const State& state)
{
    const std::vector<FoundContact> contacts = declared_contacts(state);
    if (contacts.empty()) return {};
    DisjointSets sets(static_cast<std::size_t>(state.count()));
    for (const auto& [a, contact] : contacts)
        if (state.is_movable(contact.partner))
            sets.join(static_cast<std::size_t>(a), static_cast<std::size_t>(contact.partner.index));
    struct Part {
        std::vector<std::pair<BodyId, Flight>> bodies;
        std::vector<FoundContact> contacts;
    };
    std::map<std::size_t, Part> parts;  // by their smallest bodies
    for (const FoundContact& found : contacts)
        parts[sets.smallest(static_cast<std::size_t>(found.a))].contacts.push_back(found);
    for (BodyId i = 0; i < state.count(); ++i) {
        const auto its = parts.find(sets.smallest(static_cast<std::size_t>(i)));
        if (its != parts.end() && !state.is_fixed(i)) its->second.bodies.emplace_back(i, state.flight(i));
    }
    std::vector<ContactComponent> out;
    for (auto& [smallest, part] : parts) {
        const bool alone = part.contacts.size() == 1 && part.contacts.front().contact.partner.is_plane();
        if (alone) continue;
        out.emplace_back();
        number_bodies(state, part.bodies, std::move(part.contacts), out.back());
        out.back().is_heap = part.bodies.size() > largest_group;
    }
    return out;
}

Contact sphere_contact(const State& state, BodyId a, const Flight& fa, BodyId b, const Flight& fb)
{
    const Vec3 r = separation(state.frame, fa.place, fb.place);
    const double distance = std::sqrt(r.squaredNorm());
    return lawful(state, a, Partner::sphere(b), r / distance, distance - (state.radius(a) + state.radius(b)));
}

Contact plane_contact(const State& state, BodyId a, const Flight& fa, int plane)
{
    return lawful(state, a, Partner::plane(plane), facing_normal(state, plane, fa.place),
                  height_above(state, a, plane, fa.place));
}

}  // namespace carom
