/// \file
/// A step with corners: to the first contact, respond there, go on with the rest of the step. How contacts are found is
/// left to a search; `bisection` and `toi` are its two.
///
/// Bounces come to rest in two ways: a rebound that rises no higher than the rounding of its place is none, and a
/// contact of a sphere that has had its `most_impacts` in the substep closes without rebound. Both then rest
/// (RestingContacts) until something parts them.
#pragma once

#include "stepping/path_contacts.hpp"
#include "stepping/resting_contacts.hpp"
#include "stepping/system.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <vector>

namespace carom::stepping {

/// \tparam Search is made from a Scene and has
///     begin(System&, const PathContacts&): all paths are new;
///     change(System&, const PathContacts&, BodyId, double now, const Vec3& old_target): one is;
///     for_each_pair(System&, const PathContacts&, on_pair(a, b)): spheres that may meet, a < b;
///     for_each_partner(System&, const PathContacts&, BodyId, on_partner(j)): those that one may meet;
///     may_meet(const System&, const PathContacts&, BodyId sphere, BodyId wall);
///     first(System&, const PathContacts&, a, b, double now): the optional time of the first contact.
template <class Search>
class CornerStepper {
public:
    CornerStepper(const Scene& scene, int most_impacts)
        : most_impacts_(most_impacts),
          contacts_(scene.spheres.size()),
          search_(scene),
          resting_(scene.spheres.size()),
          impacts_(scene.spheres.size())
    {
    }

    void advance(System& system, const Substep& substep)
    {
        begin(system, substep);
        while (!contacts_.is_empty() && system.patience.lasts_for(1)) {
            const Pending next = contacts_.pop();
            if (!contacts_.is_stale(system, next)) carry_out(system, substep, next);
        }
        end(system);
    }

    void finish(System&) {}

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    void begin(System& system, const Substep& substep)
    {
        contacts_.forget_all();
        std::fill(impacts_.begin(), impacts_.end(), 0);
        if (!is_crowded_) closed_.clear();  // whatever overlaps in them did so before
        resting_.support_all(system, contacts_.paths, substep.length, closed_);
        is_crowded_ = false;
        closed_.clear();
        loosened_.clear();
        contacts_.paths.begin(system.bodies, system.motion, substep.length);
        seen_.clear();
        search_.begin(system, contacts_);
        search_.for_each_pair(system, contacts_, [&](BodyId a, BodyId b) { look(system, a, b, 0); });
        for (std::size_t i = 0; i < system.bodies.size(); ++i) look_at_walls(system, static_cast<BodyId>(i), 0);
    }

    void end(System& system)
    {
        const auto record = [&](BodyId a, BodyId b) {
            system.max_penetration = std::max(system.max_penetration, -contacts_.gap_at_targets(system, a, b).value);
        };
        for (const auto& [a, b] : seen_) record(a, b);
        resting_.for_each(record);
        contacts_.paths.end(system.bodies);
    }

    void look(System& system, BodyId a, BodyId b, double now)
    {
        if (resting_.has(a, b)) return;
        if (!system.detector.is_wall(b) && system.detector.is_fixed(index(a)) && system.detector.is_fixed(index(b)))
            return;
        const double end_gap = contacts_.gap_at_targets(system, a, b).value;
        if (end_gap <= 0) seen_.emplace_back(a, b);
        if (const auto time = search_.first(system, contacts_, a, b, now))
            contacts_.foresee(system, a, b, *time, end_gap);
    }

    void look_at_walls(System& system, BodyId i, double now)
    {
        if (system.detector.is_fixed(index(i))) return;
        const auto first = static_cast<BodyId>(system.bodies.size());
        for (std::size_t w = 0; w < system.detector.walls(); ++w) {
            const BodyId b = first + static_cast<BodyId>(w);
            ++system.detector.tests;
            if (search_.may_meet(system, contacts_, i, b)) look(system, i, b, now);
        }
    }

    /// Acceleration of a towards b without the contact, positive if they press [length/time^2].
    double pressing(const System& system, const Contact& c) const
    {
        const Vec3 a = contacts_.paths.bend(c.a);
        return -(system.detector.is_wall(c.b) ? a : Vec3(a - contacts_.paths.bend(c.b))).dot(c.normal);
    }

    void carry_out(System& system, const Substep& substep, const Pending& next)
    {
        const bool pair = !system.detector.is_wall(next.b);
        const Gap gap = contacts_.gap_at(system, next.a, next.b, next.time);
        const Contact contact{gap.value, next.a, next.b, gap.normal};
        const double press = pressing(system, contact);
        const double rest = press > 0 ? speed_of_rest(system.bodies, contact, press) : 0;
        const double rate = contacts_.gap_rate(system, next.a, next.b, gap.normal, next.time);
        if (rate > rest || (rate >= 0 && press <= 0)) return;
        const bool is_spent =
            impacts_[index(next.a)] >= most_impacts_ || (pair && impacts_[index(next.b)] >= most_impacts_);
        if (is_spent && closed_.contains({next.a, next.b})) {
            // It has been stopped in this substep already: the begin of the next one stops all at once.
            is_crowded_ = true;
            resting_.add(system, next.a, next.b);
            return;
        }
        contacts_.stop(system, next.a, next.b, next.time);
        // A body that rested and is pushed on by a neighbour slower than gravity would push it does not rebound.
        const double g = std::sqrt(system.motion.gravity().squaredNorm());
        const bool is_pushed = loosened_.contains({next.a, next.b}) && rate > -substep.length * g;
        const bool rebounds = !is_spent && !is_pushed && rate < -rest;
        Impulse impulse;
        if (rebounds) impulse = respond(system.bodies, system.laws, contact);
        const bool rests = is_spent || is_pushed || (press > 0 && normal_velocity(system.bodies, contact) <= rest);
        if (rests) {
            const Impulse last = cancel_normal(system.bodies, contact);
            impulse.on_a += last.on_a;
            impulse.normal += last.normal;
            resting_.add(system, next.a, next.b);
        }
        if (is_pushed)
            system.impacts.press(contact, impulse.normal);
        else if (rate < -rest)
            system.impacts.add(contact, impulse, substep.begin + next.time);
        closed_.emplace(next.a, next.b);
        ++impacts_[index(next.a)];
        if (pair) ++impacts_[index(next.b)];
        go_on(system, contact, next.time);
    }

    /// Other paths for two that have been stopped, and for those that rested on one of them and do not any more.
    void go_on(System& system, const Contact& contact, double now)
    {
        std::vector<BodyId> two{contact.a};
        if (!system.detector.is_wall(contact.b)) two.push_back(contact.b);
        std::vector<BodyId> freed;
        for (const BodyId i : two) part(system, i, now, freed);
        for (const BodyId i : two) std::erase(freed, i);
        for (const BodyId i : freed) {
            contacts_.paths.stop_at(system.bodies, i, now);
            resting_.support(system, contacts_.paths, std::span(&i, 1));
        }
        resting_.support(system, contacts_.paths, two);
        two.insert(two.end(), freed.begin(), freed.end());
        for (const BodyId i : two) {
            const Vec3 before = contacts_.paths.target[index(i)];
            contacts_.paths.go_on(system.bodies, system.motion, i);
            search_.change(system, contacts_, i, now, before);
        }
        for (const BodyId i : two) look_again(system, i, now);
    }

    /// Ends the rest of a sphere in the contacts whose gaps change now. \param freed gets the other spheres of them
    void part(System& system, BodyId i, double now, std::vector<BodyId>& freed)
    {
        const double g = std::sqrt(system.motion.gravity().squaredNorm());
        for (const BodyId partner : std::vector<BodyId>(resting_.of(i))) {
            const BodyId a = std::min(i, partner), b = std::max(i, partner);
            const Gap gap = contacts_.gap_at(system, a, b, now);
            const double rest = speed_of_rest(system.bodies, {gap.value, a, b, gap.normal}, g);
            if (std::abs(contacts_.gap_rate(system, a, b, gap.normal, now)) <= rest) continue;
            resting_.remove(system, a, b);
            loosened_.emplace(a, b);
            if (!system.detector.is_wall(partner)) freed.push_back(partner);
        }
    }

    void look_again(System& system, BodyId i, double now)
    {
        partners_.clear();
        search_.for_each_partner(system, contacts_, i, [&](BodyId j) { partners_.push_back(j); });
        std::sort(partners_.begin(), partners_.end());  // the order of finding must not matter
        for (const BodyId j : partners_) look(system, std::min(i, j), std::max(i, j), now);
        look_at_walls(system, i, now);
    }

    int most_impacts_;
    PathContacts contacts_;
    Search search_;
    RestingContacts resting_;
    std::vector<int> impacts_;  ///< of each sphere in this substep
    std::vector<BodyId> partners_;
    std::vector<BodyPair> seen_;   ///< those that overlapped at some targets
    std::set<BodyPair> closed_;    ///< those that got a response in this substep
    bool is_crowded_ = false;      ///< something was left to close in this substep
    std::set<BodyPair> loosened_;  ///< those that rested in this substep until a neighbour moved one of them
};

}  // namespace carom::stepping
