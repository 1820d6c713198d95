/// \file
/// Bisection, going backward in time: move to the end of the substep; if spheres overlap there, find the first contact
/// by bisection, respond there, and go on with the rest of the substep. What only crosses between two looks is missed.
#include "stepping/bracket.hpp"
#include "stepping/driver.hpp"
#include "stepping/moved_spheres.hpp"
#include "stepping/path_contacts.hpp"
#include "stepping/stepping.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace carom {

namespace {

using namespace stepping;

class BisectionStepper {
public:
    explicit BisectionStepper(const std::vector<double>& radius) : contacts_(radius.size()), moved_(radius) {}

    void advance(System& system, const Substep& substep)
    {
        begin(system, substep);
        // Where bounces accumulate within a substep it would not end: beyond this number of responses nothing is
        // foreseen any more. What is known gets one response each, in order of time, and the overlap that is left then
        // is accepted.
        std::int64_t left = most_responses + most_responses_a_sphere * static_cast<std::int64_t>(system.bodies.size());
        while (!contacts_.is_empty() && system.patience.lasts_for(1)) {
            Pending next = contacts_.pop();
            settling_ = left <= 0;
            if (!settling_ && contacts_.is_stale(system, next)) continue;
            if (settling_ && !still_due(system, next)) continue;
            if (respond_at(system, substep, next)) --left;
        }
        end(system);
    }

    void finish(System&) {}

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    void begin(System& system, const Substep& substep)
    {
        StepPaths& paths = contacts_.paths;
        paths.fall(system.bodies, system.motion);
        paths.begin(system.bodies, system.motion, substep.length);
        settling_ = false;
        contacts_.forget_all();
        moved_.clear();
        seen_.clear();
        found_.clear();
        system.detector.find_pairs(paths.target, system.bodies.radius, found_);
        system.detector.find_walls(paths.target, system.bodies.radius, found_);
        for (const Contact& c : found_) add(system, c.a, c.b, c.gap, 0);
    }

    void end(System& system)
    {
        // Every pair that overlaps now was seen, because it was looked for at these very positions.
        for (const auto& [a, b] : seen_)
            system.max_penetration = std::max(system.max_penetration, -contacts_.gap_at_targets(system, a, b).value);
        contacts_.paths.end(system.bodies);
    }

    /// A pair that overlaps at its targets: when does that begin, not before `now`?
    void add(System& system, BodyId a, BodyId b, double end_gap, double now)
    {
        seen_.emplace_back(a, b);
        if (settling_) return;
        ++system.detector.tests;
        double time = now;
        const Gap start = contacts_.gap_at(system, a, b, now);
        if (start.value > 0) {
            ++system.root_solves;
            time = bisect(
                       now, contacts_.paths.length(), [&](double t) { return is_closed(system, a, b, t); },
                       system.detector.tests)
                       .before;
        } else if (contacts_.gap_rate(system, a, b, start.normal, now) >= 0) {
            // An overlap that is on its way out: on straight paths it stays so.
            if (!contacts_.paths.is_bent()) return;
            const auto closed_again = closing_after_turn(system, a, b, now);
            if (!closed_again) return;
            time = *closed_again;
        }
        contacts_.foresee(system, a, b, time, end_gap);
    }

    bool is_closed(const System& system, BodyId a, BodyId b, double time) const
    {
        return contacts_.gap_at(system, a, b, time).value <= 0;
    }

    /// Two that overlap or touch, move apart, and overlap at their targets: when do they close again, if they do? On
    /// parabolas a gap that turns to shrink goes on to do so, as long as one of the two is a plane or all but still.
    std::optional<double> closing_after_turn(System& system, BodyId a, BodyId b, double now)
    {
        const auto shrinks = [&](double t) {
            return contacts_.gap_rate(system, a, b, contacts_.gap_at(system, a, b, t).normal, t) < 0;
        };
        const double end = contacts_.paths.length();
        if (!shrinks(end)) return {};
        ++system.root_solves;
        const Bracket turn = bisect(now, end, shrinks, system.detector.tests);
        if (is_closed(system, a, b, turn.after)) return turn.after;
        const auto closed = [&](double t) { return is_closed(system, a, b, t); };
        return bisect(turn.after, end, closed, system.detector.tests).before;
    }

    /// While settling: do the two, as they move now, still overlap at the end? \param next gets a time that both have
    /// reached.
    bool still_due(const System& system, Pending& next) const
    {
        const bool pair = !system.detector.is_wall(next.b);
        next.time = std::max({next.time, contacts_.paths.since(next.a), pair ? contacts_.paths.since(next.b) : 0});
        return is_closed(system, next.a, next.b, contacts_.paths.length());
    }

    /// \return whether there was a response.
    bool respond_at(System& system, const Substep& substep, const Pending& next)
    {
        const Gap gap = contacts_.gap_at(system, next.a, next.b, next.time);
        const Contact contact{gap.value, next.a, next.b, gap.normal};
        if (contacts_.gap_rate(system, next.a, next.b, gap.normal, next.time) >= 0) return false;
        const bool pair = !system.detector.is_wall(next.b);
        contacts_.stop(system, next.a, next.b, next.time);
        system.impacts.add(contact, respond(system.bodies, system.laws, contact), substep.begin + next.time);
        go_on(system, next.a);
        if (pair) go_on(system, next.b);
        look_again(system, next.a, pair ? next.b : no_body, next.time);
        if (pair) look_again(system, next.b, no_body, next.time);
        return true;
    }

    void go_on(System& system, BodyId i)
    {
        const Vec3 before = contacts_.paths.target[index(i)];
        contacts_.paths.go_on(system.bodies, system.motion, i);
        moved_.move(i, before, contacts_.paths.target[index(i)]);
    }

    /// Contacts of sphere i at its new target, except that with `later_partner`, which finds it when its own turn
    /// comes.
    void look_again(System& system, BodyId i, BodyId later_partner, double now)
    {
        const Bodies& bodies = system.bodies;
        const std::vector<Vec3>& targets = contacts_.paths.target;
        const Vec3 target = targets[index(i)];
        const double radius = bodies.radius[index(i)];
        partners_.clear();
        moved_.for_each_near(system.detector, target, radius, [&](BodyId j) {
            if (j == i || j == later_partner) return;
            if (system.detector.is_fixed(index(i)) && system.detector.is_fixed(index(j))) return;
            ++system.detector.tests;
            const Vec3 d = target - targets[index(j)];
            if (overlap(d.x(), d.y(), d.z(), radius + bodies.radius[index(j)])) partners_.push_back(j);
        });
        std::sort(partners_.begin(), partners_.end());  // the order of finding must not matter
        for (const BodyId j : partners_) {
            const BodyId a = std::min(i, j), b = std::max(i, j);
            add(system, a, b, contacts_.gap_at_targets(system, a, b).value, now);
        }
        found_.clear();
        system.detector.find_walls_of(i, target, radius, found_);
        for (const Contact& c : found_) add(system, c.a, c.b, c.gap, now);
    }

    bool settling_ = false;  ///< too many responses in this substep
    PathContacts contacts_;
    MovedSpheres moved_;  ///< by their targets
    std::vector<BodyId> partners_;
    std::vector<Contact> found_;
    std::vector<std::pair<BodyId, BodyId>> seen_;  ///< pairs that overlapped at some target
};

}  // namespace

Outcome run_stepping(const Scene& scene, const Bisection& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, false);
    BisectionStepper stepper(system.bodies.radius);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
