/// \file
/// Naive: a response on velocity alone, for every overlapping contact, approaching or not, without correction of
/// positions. A sphere that is still overlapping a step after its bounce is turned back into the wall: it sinks and
/// sticks. A warning, kept as a positive control.
#include "stepping/driver.hpp"
#include "stepping/stepping.hpp"

namespace carom {

namespace {

using namespace stepping;

class NaiveStepper {
public:
    void advance(System& system, const Substep& substep)
    {
        system.motion.fly(system.bodies, substep.length);
        contacts_.clear();
        system.detector.find_pairs(system.bodies.position, system.bodies.radius, contacts_);
        system.detector.find_walls(system.bodies.position, system.bodies.radius, contacts_);
        system.record(contacts_);
        system.arranger.arrange(contacts_);
        for (const Contact& c : contacts_) system.impacts.add(c, respond(system.bodies, system.laws, c), substep.end);
    }

    void finish(System&) {}

private:
    std::vector<Contact> contacts_;
};

}  // namespace

Outcome run_stepping(const Scene& scene, const Naive& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, false);
    NaiveStepper stepper;
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
