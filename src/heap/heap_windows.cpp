#include "heap/heap_windows.hpp"

#include "gather/component.hpp"
#include "heap/carriers.hpp"
#include "heap/near_pairs.hpp"
#include "heap/tolerances.hpp"
#include "heap/window_part.hpp"
#include "math/disjoint_sets.hpp"

#include <algorithm>
#include <map>

namespace carom {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

class HeapWindows {
public:
    HeapWindows(const State& state, const HeapEvent& event, const EpochTime& now, const Neighbourhood& wide)
        : state_(state), event_(event), now_(now), moment_(state, now), wide_(wide), carriers_(state, moment_)
    {
        for (const BodyId body : event.bodies) seed(body);
        std::sort(seeds_.begin(), seeds_.end());
    }

    EventOutcome go()
    {
        for (const auto& piece : pieces_) end(*piece);
        // Each restart wakes bodies, ends windows of others, or asks for a longer list.
        while (!attempt()) {
        }
        const auto by_body = [](const Change& x, const Change& y) { return x.body < y.body; };
        std::sort(out_.changes.begin(), out_.changes.end(), by_body);
        const auto by_force = [](const ForceChange& x, const ForceChange& y) { return x.body < y.body; };
        std::sort(out_.forces.begin(), out_.forces.end(), by_force);
        return std::move(out_);
    }

private:
    void seed(BodyId body)
    {
        if (state_.is_fixed(body)) return;
        const auto* held = state_.bodies.as<Held>(body);
        if (held && held->rests) return;  // until something wakes it
        if (state_.bodies.is_in_heap_window(body))
            seed_piece(body);
        else if (std::find(seeds_.begin(), seeds_.end(), body) == seeds_.end())
            seeds_.push_back(body);
    }

    /// All bodies of the window that one of them is in: none of them goes on in it alone.
    /// \returns whether it is one more
    bool seed_piece(BodyId body)
    {
        const std::shared_ptr<const WindowPiece>& piece = state_.bodies.as<Windowed>(body)->piece;
        if (std::find(pieces_.begin(), pieces_.end(), piece) != pieces_.end()) return false;
        pieces_.push_back(piece);
        seeds_.insert(seeds_.end(), piece->bodies.begin(), piece->bodies.end());
        return true;
    }

    /// Ends the windows of these bodies that go on.
    /// \returns whether there are any
    bool end_others(const NearPairs& list, const std::vector<int>& part)
    {
        bool some = false;
        for (const int i : part) {
            const BodyId body = list.bodies[at(i)];
            if (!state_.bodies.is_in_heap_window(body) || !seed_piece(body)) continue;
            std::sort(seeds_.begin(), seeds_.end());
            end(*pieces_.back());
            some = true;
        }
        return some;
    }

    bool is_interrupted(const WindowPiece& piece) const { return piece.end != now_; }

    /// Ends a window: the books have what it takes in all of its length; a landing that is over rests.
    void end(const WindowPiece& piece)
    {
        for (const Load& load : piece.loads) ended_loads_.push_back({load.body, -load.force});
        carriers_.add(piece.carriers);
        if (is_interrupted(piece)) {
            double taken = 0;
            for (std::size_t k = 0; k < piece.bodies.size(); ++k) {
                const BodyId body = piece.bodies[k];
                const Flight& before = state_.flight(body);
                const Flight after = moment_.flight(body);
                taken += energy_taken(state_, body, {piece.velocities[k], after.velocity},
                                      separation(state_.frame, after.place, before.place));
            }
            out_before_.taken.window -= piece.taken - taken;
            return;
        }
        if (piece.landing && piece.landing->move + 1 == piece.landing->course->moves.size())
            rest(*piece.landing->course);
    }

    void rest(const LandingCourse& course)
    {
        for (const ContactForce& c : course.forces)
            for (const Partner b : {Partner::sphere(c.a), c.b})
                if (b.is_sphere() && !stands_still(b.index) &&
                    !std::binary_search(course.bodies.begin(), course.bodies.end(), b.index))
                    return;  // it was woken in the meantime
        std::vector<Load> further = ended_loads_;
        further.insert(further.end(), course.loads.begin(), course.loads.end());
        std::optional<std::vector<ForceChange>> carrying;
        if (!course.loads.empty()) {
            carrying = bear(further);
            if (!carrying) return;
            ended_loads_.clear();
        }
        std::map<BodyId, std::vector<PersistentContact>> contacts;
        for (const ContactForce& c : course.forces) {
            const bool first = std::binary_search(course.bodies.begin(), course.bodies.end(), c.a);
            if (first) contacts[c.a].push_back({c.b, c.force});
            if (c.b.is_sphere() && std::binary_search(course.bodies.begin(), course.bodies.end(), c.b.index))
                contacts[c.b.index].push_back({Partner::sphere(c.a), c.force});
            out_before_.events.push_back(contact_event(EventKind::rest, c.a, c.b));
        }
        for (const BodyId body : course.bodies) {
            Change change{body, moment_.flight(body), Held{Vec3::Zero(), true, true}, contacts[body]};
            change.flight.velocity = Vec3::Zero();
            change.flight.acceleration = Accelerations::none;
            out_before_.changes.push_back(change);
            std::erase(seeds_, body);
        }
        landed_.insert(landed_.end(), course.bodies.begin(), course.bodies.end());
        std::sort(landed_.begin(), landed_.end());
        if (carrying) enter_carriers(std::move(*carrying), contacts);
    }

    /// Enters the forces of bodies at rest on which others came to rest, with the contacts of these.
    void enter_carriers(std::vector<ForceChange> carrying,
                        const std::map<BodyId, std::vector<PersistentContact>>& landed)
    {
        for (const auto& [body, contacts] : landed)
            for (const PersistentContact& c : contacts) {
                if (!c.partner.is_sphere()) continue;
                for (ForceChange& its : carrying)
                    if (its.body == c.partner.index) its.contacts.push_back({Partner::sphere(body), c.force});
            }
        set_forces(std::move(carrying), out_before_);
    }

    std::optional<std::vector<ForceChange>> bear(const std::vector<Load>& further)
    {
        return carriers_.bear(further, [this](BodyId body) { return contacts_at_rest(body); });
    }

    /// Persistent contacts of bodies that rest, those that have come to rest now included.
    std::optional<std::span<const PersistentContact>> contacts_at_rest(BodyId body) const
    {
        if (!rests(body)) return {};
        for (const ForceChange& f : out_before_.forces)
            if (f.body == body) return f.contacts;
        if (std::binary_search(landed_.begin(), landed_.end(), body))
            for (const Change& c : out_before_.changes)
                if (c.body == body) return c.contacts;
        return state_.bodies.contacts().of(body);
    }

    Event contact_event(EventKind kind, BodyId a, Partner b)
    {
        const Contact contact = b.is_plane()
                                    ? plane_contact(state_, a, moment_.flight(a), b.index)
                                    : sphere_contact(state_, a, moment_.flight(a), b.index, moment_.flight(b.index));
        const BodyId other = state_.body_of(b);
        if (a < other) return {kind, {}, 0, a, other, contact.normal, Vec3::Zero()};
        return {kind, {}, 0, other, a, -contact.normal, Vec3::Zero()};
    }

    bool rests(BodyId body) const
    {
        if (std::binary_search(landed_.begin(), landed_.end(), body)) return true;
        const auto* held = state_.bodies.as<Held>(body);
        return held && held->rests && !std::binary_search(woken_.begin(), woken_.end(), body);
    }
    bool stands_still(BodyId body) const { return state_.is_fixed(body) || rests(body); }

    bool attempt()
    {
        out_ = out_before_;
        loads_ = ended_loads_;
        if (seeds_.empty()) return settle_loads();
        find_list();
        WindowBodies bodies = bodies_now(state_, moment_, list_, [this](BodyId body) { return stands_still(body); });
        DisjointSets sets(bodies.list->bodies.size());
        std::vector<char> near_rest(bodies.list->bodies.size(), 0);
        for (std::size_t k = 0; k < bodies.list->pairs.size(); ++k) {
            const NearPair& pair = bodies.list->pairs[k];
            if (pair.b.is_plane() || !bodies.is_close(k)) continue;
            const int a = pair.a, b = pair.b.index;
            if (!bodies.still[at(a)] && !bodies.still[at(b)])
                sets.join(at(a), at(b));
            else if (!bodies.still[at(a)])
                near_rest[at(a)] = near_rest[at(a)] || rests(bodies.list->bodies[at(b)]);
            else if (!bodies.still[at(b)])
                near_rest[at(b)] = near_rest[at(b)] || rests(bodies.list->bodies[at(a)]);
        }
        for (const auto& piece : pieces_)
            if (piece->landing && !is_interrupted(*piece)) join(sets, bodies, piece->landing->course->bodies);
        WindowHistory past = history();
        past.carriers = &carriers_.parts();
        past.bear = [this](const std::vector<Load>& further) {
            std::vector<Load> all = loads_;
            all.insert(all.end(), further.begin(), further.end());
            return bear(all).has_value();
        };
        struct Part {
            std::vector<int> bodies;
            bool is_concerned = false, is_at_rest = false;
        };
        std::map<std::size_t, Part> parts;
        for (std::size_t i = 0; i < bodies.list->bodies.size(); ++i) {
            if (bodies.still[i]) continue;
            Part& part = parts[sets.smallest(i)];
            part.bodies.push_back(static_cast<int>(i));
            part.is_concerned =
                part.is_concerned || std::binary_search(seeds_.begin(), seeds_.end(), bodies.list->bodies[i]);
            part.is_at_rest = part.is_at_rest || near_rest[i];
        }
        bool others_end = false;
        for (const auto& [first, part] : parts)
            others_end = (part.is_concerned && end_others(*bodies.list, part.bodies)) || others_end;
        if (others_end) {
            fresh_ = true;
            return false;
        }
        for (const auto& [first, part] : parts) {
            if (!part.is_concerned) continue;
            if (part.bodies.size() <= largest_group && !part.is_at_rest && !event_.accumulates) {
                release(bodies, part.bodies);
                continue;
            }
            const PartOutcome outcome = take_window_of_part(state_, now_, bodies, part.bodies, past, out_);
            if (outcome.next == PartOutcome::Next::lists) {
                wanted_skin_ = std::max(wanted_skin_, outcome.skin);
                fresh_ = true;
                return false;
            }
            if (outcome.next == PartOutcome::Next::wakes) {
                wake(outcome.woken);
                return false;
            }
            loads_.insert(loads_.end(), outcome.loads.begin(), outcome.loads.end());
        }
        return settle_loads();
    }

    /// Enters the forces of bodies at rest under the loads of all parts. \returns whether they bear them
    bool settle_loads()
    {
        std::erase_if(loads_, [this](const Load& load) { return !rests(load.body); });
        if (loads_.empty()) return true;
        auto forces = bear(loads_);
        if (!forces) {
            wake(carriers_.overloaded());
            return false;
        }
        set_forces(std::move(*forces), out_);
        return true;
    }

    WindowHistory history() const
    {
        WindowHistory out;
        for (const auto& piece : pieces_) {
            out.pieces.push_back(piece);
            out.is_interrupted.push_back(is_interrupted(*piece));
        }
        out.woken = woken_;
        return out;
    }

    /// Bodies of a part that is no heap fly on.
    void release(const WindowBodies& bodies, const std::vector<int>& part)
    {
        for (const int i : part) {
            const BodyId body = bodies.list->bodies[at(i)];
            if (!std::binary_search(seeds_.begin(), seeds_.end(), body)) continue;
            const MotionKind kind = state_.bodies.kind(body);
            if (kind != MotionKind::windowed && !std::binary_search(woken_.begin(), woken_.end(), body)) continue;
            Change change{body, bodies.flights[at(i)], Flying{}};
            change.flight.acceleration = state_.bodies.accelerations().free();
            out_.changes.push_back(change);
        }
    }

    /// Wakes all that persistent contacts connect with a body. What would come to rest at this very moment, or carry
    /// that, wakes with any of it.
    void wake(BodyId first)
    {
        std::vector<BodyId> frontier{first};
        const bool carries = std::any_of(out_before_.forces.begin(), out_before_.forces.end(),
                                         [&](const ForceChange& f) { return f.body == first; });
        const std::vector<BodyId> landing = landed_;
        if (carries || std::binary_search(landing.begin(), landing.end(), first)) {
            frontier = landing;
            for (const ForceChange& f : out_before_.forces) frontier.push_back(f.body);
            std::erase_if(out_before_.events, [](const Event& e) { return e.kind == EventKind::rest; });
        }
        std::vector<char> known(static_cast<std::size_t>(state_.count()), 0);
        for (const BodyId body : frontier) known[static_cast<std::size_t>(body)] = 1;
        for (std::size_t k = 0; k < frontier.size(); ++k) {
            if (std::binary_search(landing.begin(), landing.end(), frontier[k])) continue;
            for (const PersistentContact& c : state_.bodies.contacts().of(frontier[k])) {
                if (frontier[k] < c.partner.index || c.partner.is_plane() || state_.is_fixed(c.partner.index))
                    out_before_.events.push_back(contact_event(EventKind::release, frontier[k], c.partner));
                if (!c.partner.is_sphere() || state_.is_fixed(c.partner.index)) continue;
                char& its = known[static_cast<std::size_t>(c.partner.index)];
                if (!its) frontier.push_back(c.partner.index);
                its = 1;
            }
        }
        for (const BodyId body : frontier) {
            std::erase_if(out_before_.changes, [&](const Change& c) { return c.body == body; });
            std::erase_if(out_before_.forces, [&](const ForceChange& f) { return f.body == body; });
            std::erase(landed_, body);
            woken_.push_back(body);
            seeds_.push_back(body);
        }
        std::sort(woken_.begin(), woken_.end());
        std::sort(seeds_.begin(), seeds_.end());
        fresh_ = true;
    }

    void find_list()
    {
        if (list_ && !fresh_) return;
        double fastest = 0, smallest = state_.radius(seeds_.front());
        for (const BodyId body : seeds_) {
            fastest = std::max(fastest, moment_.flight(body).velocity.norm());
            smallest = std::min(smallest, state_.radius(body));
        }
        const double hot = hot_length(state_), way = hot * (fastest + hot * state_.gravity().norm());
        if (!fresh_ && pieces_.size() == 1 && landed_.empty() && lasts(*pieces_.front()->near, way)) {
            list_ = pieces_.front()->near;
            return;
        }
        const double skin = std::max({least_skin * smallest, ways_in_skin * way, wanted_skin_});
        list_ = list_near(
            state_, moment_, seeds_, std::min(skin, widest_skin(state_)),
            [this](BodyId body) { return stands_still(body); }, wide_);
        fresh_ = false;
    }

    /// Whether a list has all pairs that may meet while bodies go that way.
    bool lasts(const NearPairs& list, double way)
    {
        for (const BodyId body : seeds_)
            if (!std::binary_search(list.bodies.begin(), list.bodies.end(), body)) return false;
        double farthest = 0;
        for (std::size_t i = 0; i < list.bodies.size(); ++i) {
            if (list.still[i] && !stands_still(list.bodies[i])) return false;
            const Vec3 moved = separation(state_.frame, moment_.flight(list.bodies[i]).place, list.places[i]);
            farthest = std::max(farthest, moved.norm());
        }
        return farthest + way <= list.skin / 2;
    }

    const State& state_;
    const HeapEvent& event_;
    const EpochTime now_;
    Moment moment_;
    const Neighbourhood& wide_;
    std::vector<std::shared_ptr<const WindowPiece>> pieces_;  ///< that end, or are interrupted
    std::vector<BodyId> seeds_;                               ///< bodies that must get a motion, ascending
    std::vector<BodyId> woken_, landed_;                      ///< ascending
    std::shared_ptr<const NearPairs> list_;
    std::vector<Load> ended_loads_;  ///< of windows that ended, negative
    std::vector<Load> loads_;        ///< further loads of this event
    Carriers carriers_;
    bool fresh_ = false;       ///< a new list must be made
    double wanted_skin_ = 0;   ///< [length]
    EventOutcome out_before_;  ///< of what ended
    EventOutcome out_;
};

}  // namespace

bool is_in_windows(const State& state, BodyId body)
{
    if (const auto* window = state.bodies.as<Windowed>(body)) return window->piece != nullptr;
    const auto* held = state.bodies.as<Held>(body);
    return held && held->landed;
}

EventOutcome heap_windows(const State& state, const HeapEvent& event, const EpochTime& now, const Neighbourhood& wide)
{
    return HeapWindows(state, event, now, wide).go();
}

}  // namespace carom
