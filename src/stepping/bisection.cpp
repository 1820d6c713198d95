/// \file
/// Bisection, going backward in time: move to the end of the substep; if spheres overlap there, find the first contact
/// by bisection, respond there, and go on with the rest of the substep. What only crosses between two looks is missed.
#include "stepping/bracket.hpp"
#include "stepping/corner_stepper.hpp"
#include "stepping/driver.hpp"
#include "stepping/moved_spheres.hpp"
#include "stepping/stepping.hpp"
#include "stepping/tolerances.hpp"

#include <optional>

namespace carom {

namespace {

using namespace stepping;

/// Pairs that overlap at their targets.
class EndSearch {
public:
    explicit EndSearch(const Scene& scene) : moved_(radii(scene)) {}

    void begin(System& system, const PathContacts& contacts)
    {
        moved_.clear();
        found_.clear();
        system.detector.find_pairs(contacts.paths.target, system.bodies.radius, found_);
    }
    void change(System&, const PathContacts& contacts, BodyId i, double, const Vec3& /*old_target*/)
    {
        moved_.move(i, contacts.paths.target[index(i)]);
    }

    template <class OnPair>
    void for_each_pair(System&, const PathContacts&, OnPair&& on_pair) const
    {
        for (const Contact& c : found_) on_pair(c.a, c.b);
    }
    template <class OnPartner>
    void for_each_partner(System& system, const PathContacts& contacts, BodyId i, OnPartner&& on_partner) const
    {
        const std::vector<Vec3>& targets = contacts.paths.target;
        const std::vector<double>& radius = system.bodies.radius;
        moved_.for_each_near(system.detector, targets[index(i)], radius[index(i)], [&](BodyId j) {
            if (j == i) return;
            ++system.detector.tests;
            const Vec3 d = targets[index(i)] - targets[index(j)];
            if (overlap(d.x(), d.y(), d.z(), radius[index(i)] + radius[index(j)])) on_partner(j);
        });
    }
    bool may_meet(const System& system, const PathContacts& contacts, BodyId sphere, BodyId wall) const
    {
        return overlap(system.detector.wall(wall), contacts.paths.target[index(sphere)],
                       system.bodies.radius[index(sphere)]);
    }

    /// A pair that overlaps at its targets: when does that begin, not before `now`?
    std::optional<double> first(System& system, const PathContacts& contacts, BodyId a, BodyId b, double now) const
    {
        const auto is_closed = [&](double t) { return contacts.gap_at(system, a, b, t).value <= 0; };
        const auto shrinks = [&](double t) {
            return contacts.gap_rate(system, a, b, contacts.gap_at(system, a, b, t).normal, t) < 0;
        };
        const double end = contacts.paths.length();
        std::int64_t& tests = system.detector.tests;
        ++tests;
        if (!is_closed(now)) {
            ++system.root_solves;
            return bisect(now, end, is_closed, tests).before;
        }
        if (shrinks(now)) return now;
        // An overlap that is on its way out: on straight paths it stays so. On parabolas a gap that turns to shrink
        // goes on to do so, as long as one of the two is a plane or all but still.
        if (!contacts.paths.is_bent() || !shrinks(end)) return {};
        ++system.root_solves;
        const Bracket turn = bisect(now, end, shrinks, tests);
        return is_closed(turn.after) ? turn.after : bisect(turn.after, end, is_closed, tests).before;
    }

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }
    static std::vector<double> radii(const Scene& scene)
    {
        std::vector<double> radius;
        for (const Sphere& s : scene.spheres) radius.push_back(s.radius);
        return radius;
    }

    MovedSpheres moved_;  ///< by their targets
    std::vector<Contact> found_;
};

}  // namespace

Outcome run_stepping(const Scene& scene, const Bisection& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, false);
    CornerStepper<EndSearch> stepper(scene, ImpactSubsteps{}.most_impacts);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
