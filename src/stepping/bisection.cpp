/// \file
/// Bisection, going backward in time: move to the end of the substep; if spheres overlap there, find the first contact
/// by bisection, respond there, and go on with the rest of the substep. What only crosses between two looks is missed.
///
/// Each sphere carries its own moment: position and velocity at `since`, straight or on a parabola from there to its
/// `target` at the end of the substep. A response changes two of them; only their contacts are looked for again. (The
/// bookkeeping is this project's own.)
#include "stepping/bracket.hpp"
#include "stepping/driver.hpp"
#include "stepping/moved_spheres.hpp"
#include "stepping/step_paths.hpp"
#include "stepping/stepping.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace carom {

namespace {

using namespace stepping;

class BisectionStepper {
public:
    explicit BisectionStepper(const std::vector<double>& radius) : paths_(radius.size()), moved_(radius) {}

    void advance(System& system, const Substep& substep)
    {
        begin(system, substep);
        // Where bounces accumulate within a substep it would not end: beyond this number of responses nothing is
        // foreseen any more. What is known gets one response each, in order of time, and the overlap that is left then
        // is accepted.
        std::int64_t left = most_responses + most_responses_a_sphere * static_cast<std::int64_t>(system.bodies.size());
        while (!queue_.empty() && system.patience.lasts_for(1)) {
            Pending next = pop();
            settling_ = left <= 0;
            if (!settling_ && next.stamp != stamp(system, next.a, next.b)) continue;
            if (settling_ && !still_due(system, next)) continue;
            if (respond_at(system, substep, next)) --left;
        }
        end(system);
    }

    void finish(System&) {}

private:
    struct Pending {
        double time;        ///< since the begin of the substep
        std::int64_t rank;  ///< decides among equal times, by ContactOrder
        BodyId a, b;
        std::uint64_t stamp;
    };

    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    void begin(System& system, const Substep& substep)
    {
        Bodies& bodies = system.bodies;
        paths_.begin(bodies, system.motion, substep.length);
        settling_ = false;
        queue_.clear();
        moved_.clear();
        seen_.clear();
        contacts_.clear();
        system.detector.find_pairs(paths_.target, bodies.radius, contacts_);
        system.detector.find_walls(paths_.target, bodies.radius, contacts_);
        for (const Contact& c : contacts_) add(system, c.a, c.b, c.gap, 0);
    }

    void end(System& system)
    {
        paths_.end(system.bodies);
        // Every pair that overlaps now was seen, because it was looked for at these very positions.
        for (const auto& [a, b] : seen_) {
            const double gap =
                gap_at(system, a, b, system.bodies.position[index(a)],
                       system.detector.is_wall(b) ? Vec3(Vec3::Zero()) : system.bodies.position[index(b)])
                    .value;
            system.max_penetration = std::max(system.max_penetration, -gap);
        }
    }

    static Gap gap_at(const System& system, BodyId a, BodyId b, const Vec3& pa, const Vec3& pb)
    {
        const auto& radius = system.bodies.radius;
        if (system.detector.is_wall(b)) return wall_gap(system.detector.wall(b), pa, radius[index(a)]);
        return sphere_gap(pa, pb, radius[index(a)] + radius[index(b)]);
    }

    Gap gap_at(const System& system, BodyId a, BodyId b, double time) const
    {
        const Vec3 pa = paths_.place(system.bodies, a, time);
        return gap_at(system, a, b, pa, system.detector.is_wall(b) ? pa : paths_.place(system.bodies, b, time));
    }

    /// Rate of the gap at that time: negative when approaching [length/time].
    double gap_rate(const System& system, BodyId a, BodyId b, const Vec3& normal, double time) const
    {
        const Vec3 v = paths_.velocity(system.bodies, a, time);
        return (system.detector.is_wall(b) ? v : Vec3(v - paths_.velocity(system.bodies, b, time))).dot(normal);
    }

    std::uint64_t stamp(const System& system, BodyId a, BodyId b) const
    {
        return paths_.changes(a) + (system.detector.is_wall(b) ? 0 : paths_.changes(b));
    }

    /// A pair that overlaps at its targets: when does that begin, not before `now`?
    void add(System& system, BodyId a, BodyId b, double end_gap, double now)
    {
        seen_.emplace_back(a, b);
        if (settling_) return;
        double time = now;
        const Gap start = gap_at(system, a, b, now);
        ++system.detector.tests;
        if (start.value > 0) {
            ++system.root_solves;
            time = bisect(
                       now, paths_.length(), [&](double t) { return gap_at(system, a, b, t).value <= 0; },
                       system.detector.tests)
                       .before;
        } else if (gap_rate(system, a, b, start.normal, now) >= 0) {
            if (!paths_.is_bent()) return;  // an overlap that is on its way out: on straight paths it stays so
            const auto closed_again = closing_after_turn(system, a, b, now);
            if (!closed_again) return;
            time = *closed_again;
        }
        queue_.push_back({time, rank(system, a, b, end_gap), a, b, stamp(system, a, b)});
        std::push_heap(queue_.begin(), queue_.end(), later);
    }

    /// Two that overlap or touch, move apart, and overlap at their targets: when do they close again, if they do? On
    /// parabolas a gap that turns to shrink goes on to do so, as long as one of the two is a plane or all but still.
    std::optional<double> closing_after_turn(System& system, BodyId a, BodyId b, double now)
    {
        const auto shrinks = [&](double t) { return gap_rate(system, a, b, gap_at(system, a, b, t).normal, t) < 0; };
        const auto closed = [&](double t) { return gap_at(system, a, b, t).value <= 0; };
        if (!shrinks(paths_.length())) return {};
        ++system.root_solves;
        const Bracket turn = bisect(now, paths_.length(), shrinks, system.detector.tests);
        if (closed(turn.after)) return turn.after;
        return bisect(turn.after, paths_.length(), closed, system.detector.tests).before;
    }

    /// While settling: do the two, as they move now, still overlap at the end? \param next gets a time that both have
    /// reached.
    bool still_due(const System& system, Pending& next) const
    {
        const bool pair = !system.detector.is_wall(next.b);
        next.time = std::max({next.time, paths_.since(next.a), pair ? paths_.since(next.b) : 0});
        return gap_at(system, next.a, next.b, paths_.length()).value <= 0;
    }

    static bool later(const Pending& x, const Pending& y)
    {
        return std::tie(x.time, x.rank, x.a, x.b) > std::tie(y.time, y.rank, y.a, y.b);
    }

    Pending pop()
    {
        std::pop_heap(queue_.begin(), queue_.end(), later);
        const Pending next = queue_.back();
        queue_.pop_back();
        return next;
    }

    /// \return whether there was a response.
    bool respond_at(System& system, const Substep& substep, const Pending& next)
    {
        const Gap gap = gap_at(system, next.a, next.b, next.time);
        const Contact contact{gap.value, next.a, next.b, gap.normal};
        if (gap_rate(system, next.a, next.b, gap.normal, next.time) >= 0) return false;
        const bool pair = !system.detector.is_wall(next.b);
        paths_.stop_at(system.bodies, next.a, next.time);
        if (pair) paths_.stop_at(system.bodies, next.b, next.time);
        system.impacts.add(contact, respond(system.bodies, system.laws, contact), substep.begin + next.time);
        go_on(system, next.a);
        if (pair) go_on(system, next.b);
        look_again(system, next.a, pair ? next.b : no_body, next.time);
        if (pair) look_again(system, next.b, no_body, next.time);
        return true;
    }

    void go_on(const System& system, BodyId i)
    {
        const Vec3 before = paths_.target[index(i)];
        paths_.go_on(system.bodies, i);
        moved_.move(i, before, paths_.target[index(i)]);
    }

    /// Contacts of sphere i at its new target, except that with `later_partner`, which finds it when its own turn
    /// comes.
    void look_again(System& system, BodyId i, BodyId later_partner, double now)
    {
        const Bodies& bodies = system.bodies;
        const Vec3 target = paths_.target[index(i)];
        const double radius = bodies.radius[index(i)];
        partners_.clear();
        moved_.for_each_near(system.detector, target, radius, [&](BodyId j) {
            if (j == i || j == later_partner) return;
            if (system.detector.is_fixed(index(i)) && system.detector.is_fixed(index(j))) return;
            ++system.detector.tests;
            const Vec3 d = target - paths_.target[index(j)];
            if (overlap(d.x(), d.y(), d.z(), radius + bodies.radius[index(j)])) partners_.push_back(j);
        });
        std::sort(partners_.begin(), partners_.end());  // the order of finding must not matter
        for (const BodyId j : partners_) {
            const BodyId a = std::min(i, j), b = std::max(i, j);
            add(system, a, b, gap_at(system, a, b, paths_.target[index(a)], paths_.target[index(b)]).value, now);
        }
        contacts_.clear();
        system.detector.find_walls_of(i, target, radius, contacts_);
        for (const Contact& c : contacts_) add(system, c.a, c.b, c.gap, now);
    }

    /// Smaller goes first. Bit patterns of doubles >= 0 are ordered like their values.
    static std::int64_t rank(System& system, BodyId a, BodyId b, double end_gap)
    {
        switch (system.arranger.order()) {
            case ContactOrder::index:
            case ContactOrder::jacobi:
            case ContactOrder::shock:
                return 0;
            case ContactOrder::reverse:
                return -((std::int64_t{a} << 31) + b);
            case ContactOrder::random:
                return static_cast<std::int64_t>(system.arranger.draw() >> 1);
            case ContactOrder::deepest:
                return -std::bit_cast<std::int64_t>(std::abs(end_gap));
        }
        return 0;
    }

    bool settling_ = false;  ///< too many responses in this substep
    StepPaths paths_;
    MovedSpheres moved_;  ///< by their targets
    std::vector<BodyId> partners_;
    std::vector<Pending> queue_;
    std::vector<Contact> contacts_;
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
