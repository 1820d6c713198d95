/// \file
/// Velocity based: contacts are the gaps at the start of the substep, impulses change velocities only, positions
/// follow. Nothing ever moves overlapping spheres apart: an existing overlap persists. That is the method.
#include "stepping/driver.hpp"
#include "stepping/stepping.hpp"

namespace carom {

namespace {

using namespace stepping;

class VelocityStepper {
public:
    explicit VelocityStepper(const VelocityBased& method) : passes_(method.passes) {}

    void advance(System& system, const Substep& substep)
    {
        detect(system);
        // The positions are those that the previous substep left. The first ones are the scene's, not the method's.
        if (started_) system.record(contacts_);
        started_ = true;
        accelerate(system.bodies, system.gravity, substep.length);  // A
        if (!contacts_.empty()) {
            system.arranger.arrange(contacts_);
            for (int pass = 0; pass < passes_ && system.patience.lasts_for(contacts_.size()); ++pass) {
                bounce(system, substep);
                cancel(system, substep);
            }
        }
        move(system.bodies, substep.length);  // D
    }

    void finish(System& system)
    {
        if (!started_) return;
        detect(system);
        system.record(contacts_);
    }

private:
    void detect(System& system)
    {
        contacts_.clear();
        system.detector.find_pairs(system.bodies.position, system.bodies.radius, contacts_);
        system.detector.find_walls(system.bodies.position, system.bodies.radius, contacts_);
    }

    /// Phase B: collisions, for contacts that approach.
    void bounce(System& system, const Substep& substep)
    {
        for (const Contact& c : contacts_)
            if (normal_velocity(system.bodies, c) < 0)
                system.impacts.add(c, respond(system.bodies, system.laws, c), substep.begin);
    }

    /// Phase C: what bounces of other contacts made approach again must not deepen its overlap. A contact that phase B
    /// left separating is not touched.
    void cancel(System& system, const Substep& substep)
    {
        for (const Contact& c : contacts_)
            if (normal_velocity(system.bodies, c) < 0)
                system.impacts.add(c, cancel_normal(system.bodies, c), substep.begin);
    }

    int passes_;
    bool started_ = false;
    std::vector<Contact> contacts_;
};

}  // namespace

Outcome run_stepping(const Scene& scene, const VelocityBased& method, const RunOptions& options,
                     const Observer& observer)
{
    System system(scene, method, observer, true);
    VelocityStepper stepper(method);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
