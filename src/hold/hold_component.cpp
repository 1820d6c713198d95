#include "hold/hold_component.hpp"

#include "contact/equalise.hpp"
#include "hold/numeric_motion.hpp"
#include "hold/persistence.hpp"
#include "hold/support.hpp"
#include "hold/tolerances.hpp"
#include "math/length.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

using Indices = std::vector<std::size_t>;

/// Carries the bodies of a component on, part by part.
class Holder {
public:
    Holder(const State& state, ContactComponent component, const EpochTime& now, EventOutcome& out)
        : state_(state), contacts_(state, std::move(component)), now_(now), out_(out)
    {
    }

    HeldContacts go()
    {
        // Where a contact opens at once, all is done anew without it. It is out for good, so that this ends.
        const EventOutcome before = out_;
        while (!try_all()) out_ = before;
        const auto by_body = [](const auto& x, const auto& y) { return x.body < y.body; };
        std::sort(out_.changes.begin(), out_.changes.end(), by_body);
        std::sort(out_.forces.begin(), out_.forces.end(), by_body);
        HeldContacts held;
        for (std::size_t i = 0; i < component().problem.contacts.size(); ++i)
            held.persists.push_back(contacts_.persists(i));
        held.impulses = contacts_.impulses();
        out_.taken.settling = contacts_.energy_taken();
        return held;
    }

private:
    const ContactComponent& component() const { return contacts_.component(); }
    const Contact& contact(std::size_t i) const { return component().problem.contacts[i]; }
    std::size_t count() const { return component().problem.bodies.size(); }

    bool try_all()
    {
        shift_.assign(count(), Vec3::Zero());
        of_body_.assign(count(), {});
        const std::vector<Persistence::Part> parts = contacts_.parts();
        for (const Persistence::Part& part : parts)
            for (const std::size_t i : part.contacts) {
                of_body_[static_cast<std::size_t>(contacts_.a(i))].push_back(i);
                if (contacts_.b(i)) of_body_[static_cast<std::size_t>(*contacts_.b(i))].push_back(i);
            }
        return std::all_of(parts.begin(), parts.end(),
                           [&](const Persistence::Part& part) { return go_on(part.bodies, part.contacts); });
    }

    /// \param held persistent contacts of the part
    /// \returns false where a contact opens at once, and that is released
    bool go_on(const Indices& part, const Indices& held)
    {
        if (held.empty()) {
            out_.changes.push_back(change_of(part.front()));
            out_.changes.back().flight.acceleration = state_.bodies.accelerations().free();
            return true;
        }
        if (held.size() == 1 && contact(held.front()).partner.is_plane()) {
            lean_on(part.front(), contact(held.front()));
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

    bool was_in_piece(std::size_t k) const { return state_.bodies.is_in_piece(component().id(k)); }

    /// Bodies that end a numeric piece end it with the errors of its steps and, in contacts that closed within one, of
    /// the parabola that stood for it. Now that they stay, they give way until gaps are closed, and nobody else does.
    void close_gaps(const Indices& staying, const Indices& held)
    {
        std::vector<std::optional<int>> number(count());
        std::vector<char> stays(count(), 0);
        ContactProblem numeric;
        for (const std::size_t k : staying) {
            stays[k] = 1;
            if (!was_in_piece(k)) continue;
            number[k] = static_cast<int>(numeric.bodies.size());
            numeric.bodies.push_back(component().problem.bodies[k]);
        }
        if (numeric.bodies.empty()) return;
        std::vector<double> wanted;
        double widest = 0;
        for (const std::size_t i : held) {
            const auto a = static_cast<std::size_t>(contacts_.a(i));
            const std::optional<int> b = contacts_.b(i);
            if (!stays[a] || (b && !stays[static_cast<std::size_t>(*b)])) continue;
            const std::optional<int> number_b = b ? number[static_cast<std::size_t>(*b)] : immovable;
            if (!number[a] && !number_b) continue;
            Contact c = contact(i);
            c.a = number[a] ? *number[a] : *number_b;
            c.b = number[a] ? number_b : immovable;
            if (!number[a]) c.normal = -c.normal;
            numeric.contacts.push_back(c);
            wanted.push_back(-c.gap);
            widest = std::max(widest, std::abs(c.gap));
        }
        if (!(widest > narrow_gap * state_.rest.gap_tolerance)) return;
        const std::vector<Vec3> change = equalising_change(numeric, wanted).change;
        for (const std::size_t k : staying)
            if (number[k]) shift_[k] = change[static_cast<std::size_t>(*number[k])];
    }

    Change change_of(std::size_t k) const
    {
        Change change{component().id(k), component().flights[k]};
        Flight& f = change.flight;
        f.start = now_;
        f.velocity = component().problem.bodies[k].velocity;
        if (!shift_[k].isZero(0)) f.place = moved(state_.frame, f.place, shift_[k]);
        return change;
    }

    void lean_on(std::size_t k, const Contact& t)
    {
        // See close_gaps.
        if (was_in_piece(k)) shift_[k] = -t.gap * t.normal;
        Change change = change_of(k);
        Flight& f = change.flight;
        const double c = t.normal.dot(f.velocity);
        if (std::abs(c) > normal_speed_rounding * length(f.velocity))
            f.velocity -= (c / t.normal.squaredNorm()) * t.normal;
        lean(state_, t.partner.index, change);
        out_.changes.push_back(change);
    }

    /// \param force of a contact
    template <class Force>
    void list_contacts(Change& change, std::size_t k, const Force& force) const
    {
        for (const std::size_t i : of_body_[k]) {
            const Contact& c = contact(i);
            const BodyId a = component().id_of_a(c);
            change.contacts.push_back({a == change.body ? c.partner : Partner::sphere(a), force(i)});
        }
    }

    void stay(std::size_t k)
    {
        Change change = change_of(k);
        list_contacts(change, k, [&](std::size_t i) { return contacts_.force(i); });
        const Held held{contacts_.acceleration(k), contacts_.rests(k)};
        change.motion = held;
        if (held.rests && rested(change)) {
            out_.forces.push_back({change.body, change.contacts});
            return;
        }
        change.flight.acceleration =
            held.acceleration.isZero(0) ? Accelerations::none : state_.bodies.accelerations().own(change.body);
        out_.changes.push_back(change);
    }

    bool rested(const Change& change) const
    {
        const auto* before = state_.bodies.as<Held>(change.body);
        if (!before || !before->rests) return false;
        const auto old = state_.bodies.contacts().of(change.body);
        return std::is_permutation(
            old.begin(), old.end(), change.contacts.begin(), change.contacts.end(),
            [](const PersistentContact& x, const PersistentContact& y) { return x.partner == y.partner; });
    }

    /// \param part bodies that move; those of the component that rest carry them as if they were fixed
    /// \returns false where a contact opens at once
    bool integrate(const Indices& part, const Indices& held)
    {
        NumericMotion motion = numeric_motion(
            state_, component(), part, held, [&](std::size_t i) { return contacts_.force(i); }, now_, contacts_.soft());
        if (!motion.opened.empty()) {
            contacts_.release(motion.opened);
            return false;
        }
        for (std::size_t n = 0; n < part.size(); ++n) {
            Change change = change_of(part[n]);
            list_contacts(change, part[n], [&](std::size_t i) { return motion.mean_forces[i]; });
            change.motion = motion.pieces[n];
            change.flight.acceleration = state_.bodies.accelerations().own(change.body);
            out_.changes.push_back(change);
        }
        out_.taken.stabilising += motion.correction;
        out_.penetration = std::max(out_.penetration, motion.depth);
        ++out_.numeric_steps;
        return true;
    }

    const State& state_;
    Persistence contacts_;
    const EpochTime now_;
    std::vector<Indices> of_body_;  ///< by body: its persistent contacts
    std::vector<Vec3> shift_;       ///< by body: what closes its gaps [length]
    EventOutcome& out_;
};

}  // namespace

HeldContacts hold(const State& state, ContactComponent component, const EpochTime& now, EventOutcome& out)
{
    return Holder(state, std::move(component), now, out).go();
}

}  // namespace carom
