/// \file
/// Continuous collision by substeps at its best: in each step go to the first contact, found as a root of the gap on
/// the method's own paths, respond there, go on with the rest of the step. (Conservative advancement and its kin in
/// Bullet, Box2D, Jolt and Rapier do this once or a few times a step, with what is left of the step lost; here nothing
/// is.)
#include "stepping/corner_stepper.hpp"
#include "stepping/driver.hpp"
#include "stepping/path_roots.hpp"
#include "stepping/stepping.hpp"
#include "stepping/swept_spheres.hpp"

namespace carom {

namespace {

using namespace stepping;

class RootSearch {
public:
    explicit RootSearch(const Scene& scene) : swept_(scene) {}

    void begin(System& system, const PathContacts& contacts) { swept_.begin(system, contacts.paths); }
    void change(System& system, const PathContacts& contacts, BodyId i, double now, const Vec3&)
    {
        swept_.change(system, contacts.paths, i, now);
    }

    template <class OnPair>
    void for_each_pair(System& system, const PathContacts&, OnPair&& on_pair) const
    {
        swept_.for_each_pair(system, on_pair);
    }
    template <class OnPartner>
    void for_each_partner(System& system, const PathContacts&, BodyId i, OnPartner&& on_partner) const
    {
        swept_.for_each_partner(system, i, on_partner);
    }
    bool may_meet(const System& system, const PathContacts&, BodyId sphere, BodyId wall) const
    {
        return swept_.may_meet(system.detector.wall(wall), sphere);
    }

    std::optional<double> first(System& system, const PathContacts& contacts, BodyId a, BodyId b, double now) const
    {
        return first_contact(system, contacts, a, b, now);
    }

private:
    SweptSpheres swept_;
};

}  // namespace

Outcome run_stepping(const Scene& scene, const ImpactSubsteps& method, const RunOptions& options,
                     const Observer& observer)
{
    System system(scene, method, observer, false);
    if (method.most_impacts < 1) {
        Outcome outcome;
        outcome.status = Status::unresolved;
        outcome.message = "most_impacts must be at least 1, is " + std::to_string(method.most_impacts);
        return collect(system, outcome);
    }
    CornerStepper<RootSearch> stepper(scene, method.most_impacts);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
