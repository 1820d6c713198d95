#include "event_driven/hold_component.hpp"

#include "contact/equalise.hpp"
#include "event_driven/motion.hpp"
#include "event_driven/numeric_motion.hpp"
#include "event_driven/support.hpp"
#include "impact/contact_forces.hpp"
#include "math/length.hpp"

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

double largest_speed(const ContactComponent& component)
{
    double largest = 0;
    for (const Flight& f : component.flights) largest = std::max(largest, f.velocity.squaredNorm());
    return std::sqrt(largest);
}

class Holder {
public:
    Holder(const State& state, ContactComponent component, const EpochTime& now)
        : state_(state),
          component_(std::move(component)),
          now_(now),
          gravity_(state.accelerations[state.accelerations.free()]),
          slow_(std::max(1e-6 * state.rest.closing_speed, 1e-12 * largest_speed(component_))),
          soft_(1e-9 * length(gravity_))
    {
        out_.impulses.assign(component_.contacts.size(), 0);
    }

    HeldComponent go()
    {
        choose_candidates();
        find_forces();
        std::vector<char> opens = let_open();
        stop_closing();
        push_apart(std::move(opens));
        bring_to_rest();
        // A part of which a contact opens at once is looked at again without it, and perhaps in pieces.
        std::vector<std::vector<std::size_t>> todo = parts();
        while (!todo.empty()) {
            const std::vector<std::size_t> part = std::move(todo.back());
            todo.pop_back();
            if (go_on(part)) continue;
            for (std::vector<std::size_t>& piece : parts())
                if (std::binary_search(part.begin(), part.end(), piece.front())) todo.push_back(std::move(piece));
        }
        std::sort(out_.changes.begin(), out_.changes.end(),
                  [](const MemberChange& x, const MemberChange& y) { return x.body < y.body; });
        out_.persists = std::move(persists_);
        return std::move(out_);
    }

private:
    std::size_t count() const { return component_.contacts.size(); }
    Flight& flight(int index) { return component_.flights[static_cast<std::size_t>(index)]; }
    Vec3 relative_velocity(const Touch& t) const
    {
        const Vec3& v = component_.flight_of(t.a).velocity;
        return component_.index_of(t.b) == immovable ? v : Vec3(v - component_.flight_of(t.b).velocity);
    }
    double rate(const Touch& t) const { return t.normal.dot(relative_velocity(t)); }

    void choose_candidates()
    {
        const bool absorbs = loses_energy();
        for (const Touch& t : component_.contacts) {
            const double c = rate(t);
            const double most = absorbs ? state_.rest.closing_speed : slow_;
            persists_.push_back(t.gap <= persistence_gap(state_, t.a, t.b) && c <= std::max(slow_, most));
        }
    }

    /// In components with some e < 1 a contact that opens slower than v_c while forces press it comes back slower than
    /// v_c, and then has no rebound: it persists at once.
    bool loses_energy() const
    {
        return state_.scene.rest.policy == RestPolicy::contact &&
               std::any_of(component_.contacts.begin(), component_.contacts.end(),
                           [&](const Touch& t) { return state_.law(t.a, t.b).restitution < 1; });
    }

    /// What persists neither opens nor closes from here on: what is left of its speed goes.
    void stop_closing()
    {
        std::vector<double> wanted(count(), 0);
        for (std::size_t i = 0; i < count(); ++i)
            if (persists_[i]) wanted[i] = -rate(component_.contacts[i]);
        const double before = kinetic_energy();
        equalise(persists_, wanted);
        out_.taken.settling += before - kinetic_energy();
    }

    /// Gap rates of some contacts change as wanted, by impulses along their normals.
    void equalise(const std::vector<char>& which, const std::vector<double>& wanted)
    {
        Cluster all = cluster_of(state_, component_);
        Cluster some{all.bodies, {}};
        std::vector<double> changes;
        for (std::size_t i = 0; i < count(); ++i) {
            if (!which[i]) continue;
            some.contacts.push_back(all.contacts[i]);
            changes.push_back(wanted[i]);
        }
        if (changes.empty()) return;
        const EqualisingChange change = equalising_change(some, changes);
        for (std::size_t k = 0; k < change.change.size(); ++k) component_.flights[k].velocity += change.change[k];
        for (std::size_t i = 0, n = 0; i < count(); ++i)
            if (which[i]) out_.impulses[i] += change.impulses[n++];
    }

    double kinetic_energy() const
    {
        double sum = 0;
        for (std::size_t k = 0; k < component_.bodies.size(); ++k)
            sum += component_.flights[k].velocity.squaredNorm() / 2 / state_.inverse_mass(component_.bodies[k]);
        return sum;
    }

    Cluster candidates() const
    {
        Cluster all = cluster_of(state_, component_), out{all.bodies, {}};
        for (std::size_t i = 0; i < count(); ++i)
            if (persists_[i]) out.contacts.push_back(all.contacts[i]);
        return out;
    }

    void find_forces()
    {
        Cluster problem = candidates();
        force_.assign(count(), 0);
        opening_.assign(count(), 0);
        acceleration_.assign(component_.bodies.size(), gravity_);
        if (problem.contacts.empty()) return;
        for (ClusterBody& body : problem.bodies) body.velocity = gravity_;
        std::vector<double> curvature;
        for (std::size_t i = 0; i < count(); ++i)
            if (persists_[i]) curvature.push_back(turning(component_.contacts[i]));
        const ContactForces forces = solve_contact_forces(problem, curvature, forces_before());
        acceleration_ = forces.accelerations;
        for (std::size_t i = 0, k = 0; i < count(); ++i) {
            if (!persists_[i]) continue;
            force_[i] = forces.forces[k];
            opening_[i] = forces.gap_rates[k];
            ++k;
        }
    }

    /// Of the candidates, as they were when their bodies last changed.
    std::vector<double> forces_before() const
    {
        std::vector<double> out;
        for (std::size_t i = 0; i < count(); ++i) {
            if (!persists_[i]) continue;
            const Touch& t = component_.contacts[i];
            out.push_back(state_.contacts.force(t.a, t.b));
        }
        return out;
    }

    /// |w_t|^2 / (r_a + r_b), 0 at planes.
    double turning(const Touch& t) const
    {
        if (state_.is_plane(t.b)) return 0;
        const Vec3 w = relative_velocity(t);
        return (w - w.dot(t.normal) * t.normal).squaredNorm() / (state_.radius(t.a) + state_.radius(t.b));
    }

    /// \returns by contact: it opens, from speed 0
    std::vector<char> let_open()
    {
        std::vector<char> opens(count(), 0);
        for (std::size_t i = 0; i < count(); ++i) {
            if (!persists_[i] || force_[i] > 0) continue;
            const Touch& t = component_.contacts[i];
            const bool opens_already = rate(t) > slow_;
            opens[i] = !opens_already && opening_[i] > std::max(soft_, softest(t));
            if (opens[i] || opens_already) persists_[i] = false;
        }
        return opens;
    }
    /// Without gravity: what opens a contact by less than its tolerance until the end of the run.
    double softest(const Touch& t) const
    {
        const double time = state_.scene.end_time;
        return length(gravity_) > 0 ? 0 : persistence_gap(state_, t.a, t.b) / time / time;
    }

    /// Contacts open from speed 0; by rounding that must not look like closing to those who predict.
    void push_apart(std::vector<char> opens)
    {
        constexpr int most_pushes = 40;
        double margin = 16 * unit_roundoff * std::max(largest_speed(component_), slow_);
        const double enough = margin / 2;
        std::vector<char> moved(count(), 0);
        for (int n = 0; n < most_pushes && margin <= std::max(slow_, 4 * enough); ++n, margin *= 2) {
            bool all_open = true;
            std::vector<double> wanted(count(), 0);
            for (std::size_t i = 0; i < count(); ++i) {
                const double c = rate(component_.contacts[i]);
                if (!persists_[i] && c < 0) opens[i] = 1;  // what was done to others has made it close again
                moved[i] = opens[i] || persists_[i];
                if (!moved[i]) continue;
                wanted[i] = opens[i] ? std::max(margin - c, 0.0) : -c;
                if (opens[i] && !(c > enough)) all_open = false;
            }
            if (all_open) return;
            equalise(moved, wanted);
        }
    }

    /// Speeds and accelerations that are no more than what solving leaves of 0, where contacts hold a body.
    void bring_to_rest()
    {
        for (std::size_t k = 0; k < component_.bodies.size(); ++k) {
            if (!is_held(component_.bodies[k])) continue;
            Vec3 &v = component_.flights[k].velocity, &a = acceleration_[k];
            if (length(a) <= soft_) a = Vec3::Zero();
            if (a.isZero(0) && length(v) <= slow_) v = Vec3::Zero();
        }
    }

    bool is_held(BodyId body) const
    {
        for (std::size_t i = 0; i < count(); ++i)
            if (persists_[i] && (component_.contacts[i].a == body || component_.contacts[i].b == body)) return true;
        return false;
    }

    /// The bodies, as indices, that persistent contacts still connect.
    std::vector<std::vector<std::size_t>> parts() const
    {
        const std::size_t n = component_.bodies.size();
        std::vector<std::size_t> smallest(n);
        for (std::size_t k = 0; k < n; ++k) smallest[k] = k;
        const auto root = [&](std::size_t k) {
            while (smallest[k] != k) k = smallest[k] = smallest[smallest[k]];
            return k;
        };
        for (std::size_t i = 0; i < count(); ++i) {
            const int b = component_.index_of(component_.contacts[i].b);
            if (!persists_[i] || b == immovable) continue;
            const std::size_t x = root(static_cast<std::size_t>(component_.index_of(component_.contacts[i].a))),
                              y = root(static_cast<std::size_t>(b));
            smallest[std::max(x, y)] = std::min(x, y);
        }
        std::vector<std::vector<std::size_t>> out, by_root(n);
        for (std::size_t k = 0; k < n; ++k) by_root[root(k)].push_back(k);
        for (auto& part : by_root)
            if (!part.empty()) out.push_back(std::move(part));
        return out;
    }

    /// \returns false where a contact opens at once, and then nothing is done
    bool go_on(const std::vector<std::size_t>& part)
    {
        std::vector<std::size_t> held;
        for (std::size_t i = 0; i < count(); ++i) {
            const int a = component_.index_of(component_.contacts[i].a);
            if (persists_[i] && std::binary_search(part.begin(), part.end(), static_cast<std::size_t>(a)))
                held.push_back(i);
        }
        const Touch* first = held.empty() ? nullptr : &component_.contacts[held.front()];
        if (first == nullptr) {
            fly(part.front());
            return true;
        }
        if (held.size() == 1 && state_.is_plane(first->b)) {
            lean(part.front(), *first);
            return true;
        }
        // Also one that carries nothing now: its gap may open, or it may carry a moment later.
        const bool rolls =
            std::any_of(held.begin(), held.end(), [&](std::size_t i) { return turns(component_.contacts[i]); });
        std::vector<std::size_t> moving, staying;
        for (const std::size_t k : part) (rolls && !rests(k) ? moving : staying).push_back(k);
        if (!moving.empty() && !integrate(moving, held)) return false;
        close_gaps(staying, held);
        for (const std::size_t k : staying) stay(k, held);
        return true;
    }

    /// Bodies that end a numeric piece end it with the errors of its steps and, in contacts that closed within one, of
    /// the parabola that stood for it. Now that they stay, they give way until gaps are closed, and nobody else does.
    void close_gaps(const std::vector<std::size_t>& staying, const std::vector<std::size_t>& held)
    {
        const Cluster all = cluster_of(state_, component_);
        std::vector<int> number(component_.bodies.size(), immovable);
        std::vector<char> stays(component_.bodies.size(), 0);
        Cluster numeric;
        for (const std::size_t k : staying) {
            stays[k] = 1;
            if (state_.flight(component_.bodies[k]).mode != Mode::numeric) continue;
            number[k] = static_cast<int>(numeric.bodies.size());
            numeric.bodies.push_back(all.bodies[k]);
        }
        std::vector<double> wanted;
        double widest = 0;
        for (const std::size_t i : held) {
            ClusterContact c = all.contacts[i];
            if (!stays[static_cast<std::size_t>(c.a)] || (c.b != immovable && !stays[static_cast<std::size_t>(c.b)]))
                continue;
            c.a = number[static_cast<std::size_t>(c.a)];
            c.b = c.b == immovable ? immovable : number[static_cast<std::size_t>(c.b)];
            if (c.a == immovable) {
                std::swap(c.a, c.b);
                c.normal = -c.normal;
            }
            if (c.a == immovable) continue;
            numeric.contacts.push_back(c);
            wanted.push_back(-component_.contacts[i].gap);
            widest = std::max(widest, std::abs(component_.contacts[i].gap));
        }
        if (!(widest > 1e-3 * state_.rest.gap_tolerance)) return;
        const std::vector<Vec3> change = equalising_change(numeric, wanted).change;
        for (const std::size_t k : staying) {
            if (number[k] == immovable) continue;
            Place& place = component_.flights[k].place;
            place = moved(state_.frame, place, change[static_cast<std::size_t>(number[k])]);
        }
    }

    bool rests(std::size_t k) const { return component_.flights[k].velocity.isZero(0) && acceleration_[k].isZero(0); }

    /// Does the normal turn? Then what it carries has no closed form.
    bool turns(const Touch& t) const
    {
        if (state_.is_plane(t.b)) return false;
        const int b = component_.index_of(t.b);
        const Vec3& a = acceleration_[static_cast<std::size_t>(component_.index_of(t.a))];
        const Vec3 relative = b == immovable ? a : Vec3(a - acceleration_[static_cast<std::size_t>(b)]);
        return length(relative_velocity(t)) > slow_ || length(relative) > 4 * soft_;
    }

    MemberChange& change_of(std::size_t k)
    {
        Flight f = component_.flights[k];
        f.start = now_;
        out_.changes.push_back({component_.bodies[k], f, Vec3::Zero(), {}, {}, false});
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
        Flight& f = change_of(k).flight;
        const double c = t.normal.dot(f.velocity);
        if (std::abs(c) > 4 * unit_roundoff * length(f.velocity)) f.velocity -= (c / t.normal.squaredNorm()) * t.normal;
        carom::hold(state_, state_.plane_index(t.b), f);
    }

    void list_contacts(MemberChange& change, const std::vector<std::size_t>& held)
    {
        for (const std::size_t i : held) {
            const Touch& t = component_.contacts[i];
            if (t.a == change.body) change.contacts.push_back({t.b, force_[i]});
            if (t.b == change.body) change.contacts.push_back({t.a, force_[i]});
        }
        change.flight.support = several_supports;
    }

    void stay(std::size_t k, const std::vector<std::size_t>& held)
    {
        MemberChange& change = change_of(k);
        list_contacts(change, held);
        change.acceleration = acceleration_[k];
        Flight& f = change.flight;
        f.acceleration = change.acceleration.isZero(0) ? Accelerations::none : state_.accelerations.own(change.body);
        f.mode = rests(k) ? Mode::resting : Mode::sliding;
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
    bool integrate(const std::vector<std::size_t>& part, const std::vector<std::size_t>& held)
    {
        NumericPart numeric{{}, {}};
        std::vector<std::size_t> number;  // of its contacts
        for (const std::size_t k : part) numeric.bodies.push_back({component_.bodies[k], component_.flights[k]});
        const auto moves = [&](BodyId body) {
            const int k = component_.index_of(body);
            return k != immovable && !rests(static_cast<std::size_t>(k));
        };
        for (const std::size_t i : held) {
            const Touch& t = component_.contacts[i];
            if (!moves(t.a) && !moves(t.b)) continue;
            number.push_back(i);
            numeric.contacts.push_back({t, force_[i], {}});
            const BodyId other = moves(t.a) ? t.b : t.a;
            if (!state_.is_plane(other) && !moves(other))
                numeric.contacts.back().other =
                    state_.is_fixed(other) ? state_.flight(other).place : component_.flight_of(other).place;
        }
        const NumericMotion motion = numeric_motion(state_, numeric, now_, soft_);
        if (!motion.opened.empty()) {
            std::vector<char> opens(count(), 0);
            for (const std::size_t n : motion.opened) opens[number[n]] = 1;
            for (std::size_t i = 0; i < count(); ++i)
                if (opens[i]) persists_[i] = 0;
            push_apart(std::move(opens));
            return false;
        }
        for (std::size_t n = 0; n < part.size(); ++n) {
            MemberChange& change = change_of(part[n]);
            list_contacts(change, held);
            for (PersistentContact& c : change.contacts) c.force = mean_force(motion, numeric, change.body, c.partner);
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

    static double mean_force(const NumericMotion& motion, const NumericPart& part, BodyId body, BodyId partner)
    {
        for (std::size_t i = 0; i < part.contacts.size(); ++i) {
            const Touch& t = part.contacts[i].touch;
            if ((t.a == body && t.b == partner) || (t.b == body && t.a == partner)) return motion.forces[i];
        }
        return 0;
    }

    const State& state_;
    ContactComponent component_;
    const EpochTime now_;
    const Vec3 gravity_;
    const double slow_;               ///< contacts no faster than this neither open nor close [length/time]
    const double soft_;               ///< accelerations up to this are 0 [length/time^2]
    std::vector<char> persists_;      ///< by contact
    std::vector<double> force_;       ///< by contact [mass length/time^2]
    std::vector<double> opening_;     ///< by contact, d2 gap / dt2 [length/time^2]
    std::vector<Vec3> acceleration_;  ///< by body [length/time^2]
    HeldComponent out_;
};

}  // namespace

HeldComponent hold(const State& state, ContactComponent component, const EpochTime& now)
{
    return Holder(state, std::move(component), now).go();
}

}  // namespace carom
