#include "event_driven/hold_component.hpp"

#include "contact/equalise.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/numeric_motion.hpp"
#include "event_driven/persistence.hpp"
#include "event_driven/support.hpp"
#include "math/error_free.hpp"
#include "math/length.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

using Indices = std::vector<std::size_t>;

/// Carries the bodies of a component on, part by part.
class Holder {
public:
    Holder(const State& state, ContactComponent component, const EpochTime& now)
        : state_(state), contacts_(state, std::move(component)), now_(now)
    {
    }

    HeldComponent go()
    {
        // Where a contact opens at once, all is done anew without it. It is out for good, so that this ends.
        while (!try_all()) continue;
        std::sort(out_.changes.begin(), out_.changes.end(),
                  [](const MemberChange& x, const MemberChange& y) { return x.body < y.body; });
        for (std::size_t i = 0; i < component().contacts.size(); ++i) out_.persists.push_back(contacts_.persists(i));
        out_.impulses = contacts_.impulses();
        out_.taken.settling = contacts_.energy_taken();
        return std::move(out_);
    }

private:
    const ContactComponent& component() const { return contacts_.component(); }
    const Touch& touch(std::size_t contact) const { return component().contacts[contact]; }

    bool try_all()
    {
        out_ = {};
        shift_.assign(component().bodies.size(), Vec3::Zero());
        const std::vector<Indices> parts = contacts_.parts(), held = contacts_.contacts_of(parts);
        sort_by_body(held);
        for (std::size_t p = 0; p < parts.size(); ++p)
            if (!go_on(parts[p], held[p])) return false;
        return true;
    }

    void sort_by_body(const std::vector<Indices>& held)
    {
        of_body_.assign(component().bodies.size(), {});
        for (const Indices& some : held)
            for (const std::size_t i : some) {
                of_body_[static_cast<std::size_t>(contacts_.a(i))].push_back(i);
                if (contacts_.b(i)) of_body_[static_cast<std::size_t>(*contacts_.b(i))].push_back(i);
            }
    }

    /// \param held persistent contacts of the part
    /// \returns false where a contact opens at once, and that is released
    bool go_on(const Indices& part, const Indices& held)
    {
        if (held.empty()) {
            fly(part.front());
            return true;
        }
        if (held.size() == 1 && state_.is_plane(touch(held.front()).b)) {
            lean(part.front(), touch(held.front()));
            return true;
        }
        // Also one that carries nothing now: its gap may open, or it may carry a moment later.
        const bool rolls = std::any_of(held.begin(), held.end(), [&](std::size_t i) { return contacts_.turns(i); });
        Indices moving, staying;
        for (const std::size_t k : part) (rolls && !contacts_.rests(k) ? moving : staying).push_back(k);
        if (!moving.empty() && !integrate(moving, held)) return false;
        close_gaps(staying, held);
        for (const std::size_t k : staying) stay(k);
        return true;
    }

    /// Bodies that end a numeric piece end it with the errors of its steps and, in contacts that closed within one, of
    /// the parabola that stood for it. Now that they stay, they give way until gaps are closed, and nobody else does.
    void close_gaps(const Indices& staying, const Indices& held)
    {
        std::vector<std::optional<int>> number(component().bodies.size());
        std::vector<char> stays(component().bodies.size(), 0);
        ContactProblem numeric;
        for (const std::size_t k : staying) {
            stays[k] = 1;
            const BodyId body = component().bodies[k];
            if (state_.flight(body).mode != Mode::numeric) continue;
            number[k] = static_cast<int>(numeric.bodies.size());
            numeric.bodies.push_back({component().flights[k].velocity, state_.inverse_mass(body)});
        }
        if (numeric.bodies.empty()) return;
        std::vector<double> wanted;
        double widest = 0;
        for (const std::size_t i : held) {
            const auto a = static_cast<std::size_t>(contacts_.a(i));
            const std::optional<int> b = contacts_.b(i);
            if (!stays[a] || (b && !stays[static_cast<std::size_t>(*b)])) continue;
            const std::optional<int> number_b = b ? number[static_cast<std::size_t>(*b)] : immovable;
            if (number[a])
                numeric.contacts.push_back({*number[a], number_b, touch(i).normal, 0, 1});
            else if (number_b)
                numeric.contacts.push_back({*number_b, immovable, -touch(i).normal, 0, 1});
            else
                continue;
            wanted.push_back(-touch(i).gap);
            widest = std::max(widest, std::abs(touch(i).gap));
        }
        if (!(widest > 1e-3 * state_.rest.gap_tolerance)) return;
        const std::vector<Vec3> change = equalising_change(numeric, wanted).change;
        for (const std::size_t k : staying)
            if (number[k]) shift_[k] = change[static_cast<std::size_t>(*number[k])];
    }

    MemberChange& change_of(std::size_t k)
    {
        Flight f = component().flights[k];
        f.start = now_;
        if (!shift_[k].isZero(0)) f.place = moved(state_.frame, f.place, shift_[k]);
        out_.changes.push_back({component().bodies[k], f, Vec3::Zero(), {}, {}, false});
        return out_.changes.back();
    }

    void fly(std::size_t k)
    {
        Flight& f = change_of(k).flight;
        f.acceleration = state_.accelerations.free();
        f.support = -1;
        f.mode = Mode::flying;
    }

    void lean(std::size_t k, const Touch& t)
    {
        // See close_gaps.
        if (state_.flight(component().bodies[k]).mode == Mode::numeric) shift_[k] = -t.gap * t.normal;
        Flight& f = change_of(k).flight;
        const double c = t.normal.dot(f.velocity);
        if (std::abs(c) > 4 * unit_roundoff * length(f.velocity)) f.velocity -= (c / t.normal.squaredNorm()) * t.normal;
        carom::hold(state_, state_.plane_index(t.b), f);
    }

    /// \param force of a contact
    template <class Force>
    void list_contacts(MemberChange& change, std::size_t k, const Force& force) const
    {
        for (const std::size_t i : of_body_[k]) {
            const Touch& t = touch(i);
            change.contacts.push_back({t.a == change.body ? t.b : t.a, force(i)});
        }
        change.flight.support = several_supports;
    }

    void stay(std::size_t k)
    {
        MemberChange& change = change_of(k);
        list_contacts(change, k, [&](std::size_t i) { return contacts_.force(i); });
        change.acceleration = contacts_.acceleration(k);
        Flight& f = change.flight;
        f.acceleration = change.acceleration.isZero(0) ? Accelerations::none : state_.accelerations.own(change.body);
        f.mode = contacts_.rests(k) ? Mode::resting : Mode::sliding;
        change.rests_on = f.mode == Mode::resting && rested(change);
    }

    bool rested(const MemberChange& change) const
    {
        const Flight& before = state_.flight(change.body);
        if (before.mode != Mode::resting || before.support != several_supports) return false;
        const auto old = state_.contacts.of(change.body);
        return std::is_permutation(
            old.begin(), old.end(), change.contacts.begin(), change.contacts.end(),
            [](const PersistentContact& x, const PersistentContact& y) { return x.partner == y.partner; });
    }

    /// \param part bodies that move; those of the component that rest carry them as if they were fixed
    /// \returns false where a contact opens at once
    bool integrate(const Indices& part, const Indices& held)
    {
        NumericPart numeric{{}, {}};
        Indices number;  // of its contacts
        for (const std::size_t k : part) numeric.bodies.push_back({component().bodies[k], component().flights[k]});
        const auto moves = [&](std::optional<int> k) { return k && !contacts_.rests(static_cast<std::size_t>(*k)); };
        for (const std::size_t i : held) {
            const Touch& t = touch(i);
            const bool a_moves = moves(contacts_.a(i));
            if (!a_moves && !moves(contacts_.b(i))) continue;
            number.push_back(i);
            numeric.contacts.push_back({t, contacts_.force(i), {}});
            const BodyId other = a_moves ? t.b : t.a;
            const std::optional<int> k = a_moves ? contacts_.b(i) : contacts_.a(i);
            if (!state_.is_plane(other) && !moves(k))
                numeric.contacts.back().other =
                    k ? component().flights[static_cast<std::size_t>(*k)].place : state_.flight(other).place;
        }
        const NumericMotion motion = numeric_motion(state_, numeric, now_, contacts_.soft());
        if (!motion.opened.empty()) {
            std::vector<char> opens(component().contacts.size(), 0);
            for (const std::size_t n : motion.opened) opens[number[n]] = 1;
            contacts_.release(std::move(opens));
            return false;
        }
        std::vector<double> mean_force(component().contacts.size(), 0);
        for (std::size_t n = 0; n < number.size(); ++n) mean_force[number[n]] = motion.forces[n];
        for (std::size_t n = 0; n < part.size(); ++n) {
            MemberChange& change = change_of(part[n]);
            list_contacts(change, part[n], [&](std::size_t i) { return mean_force[i]; });
            change.piece = motion.pieces[n];
            change.acceleration = motion.accelerations[n];
            change.flight.acceleration = state_.accelerations.own(change.body);
            change.flight.mode = Mode::numeric;
        }
        out_.taken.stabilising += motion.correction;
        out_.depth = std::max(out_.depth, motion.depth);
        ++out_.numeric_steps;
        return true;
    }

    const State& state_;
    Persistence contacts_;
    const EpochTime now_;
    std::vector<Indices> of_body_;  ///< by body: its persistent contacts
    std::vector<Vec3> shift_;       ///< by body: what closes its gaps [length]
    HeldComponent out_;
};

}  // namespace

HeldComponent hold(const State& state, ContactComponent component, const EpochTime& now)
{
    return Holder(state, std::move(component), now).go();
}

}  // namespace carom
