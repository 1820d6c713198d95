/// \file
/// Velocity based: contacts are the gaps at the start of the substep, impulses change velocities only, positions
/// follow. Nothing ever moves overlapping spheres apart: an existing overlap persists. That is the method.
///
/// With Integrator::parabola bounces act where the gap is seen, at the start, on the velocities there: what flies on
/// from an elastic bounce keeps its energy to rounding. What gravity then adds against a closed contact is cancelled as
/// a force that lasts the substep (FreeMotion::move_pushed). With Integrator::euler both act on the velocities that
/// gravity has changed already, as the handout has it.
///
/// With ContactOrder::shock contacts are visited from the ground up, and what still approaches after all passes is
/// cancelled once more, level by level, with those below infinitely heavy (contact_levels.hpp).
#include "stepping/contact_levels.hpp"
#include "stepping/driver.hpp"
#include "stepping/stepping.hpp"

#include <array>

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
        arrange(system);
        if (system.motion.integrator() == Integrator::parabola) {
            respond_in_passes(system, substep);
            system.motion.accelerate(system.bodies, substep.length);
            support_in_passes(system, substep);
        } else {
            system.motion.accelerate(system.bodies, substep.length);  // A
            respond_in_passes(system, substep);                       // B, C
        }
        if (propagates(system)) propagate(system, substep);
        system.motion.move_pushed(system.bodies, substep.length);  // D
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

    static bool propagates(const System& system) { return system.arranger.order() == ContactOrder::shock; }

    void arrange(System& system)
    {
        if (propagates(system))
            levels_.arrange(system.bodies, contacts_);
        else
            system.arranger.arrange(contacts_);
    }

    void respond_in_passes(System& system, const Substep& substep)
    {
        for (int pass = 0; pass < passes_ && may_go_on(system); ++pass) {
            bounce(system, substep);
            cancel(system, substep);
        }
    }

    void support_in_passes(System& system, const Substep& substep)
    {
        for (int pass = 0; pass < passes_ && may_go_on(system); ++pass) cancel(system, substep);
    }

    bool may_go_on(System& system) const { return !contacts_.empty() && system.patience.lasts_for(contacts_.size()); }

    /// Approaches that are left, cancelled from the ground up, at the cost of what is above.
    void propagate(System& system, const Substep& substep)
    {
        levels_.propagate(system.bodies, [&](std::size_t begin, std::size_t end) {
            for (int pass = 0; pass < passes_ && may_go_on(system); ++pass)
                for (std::size_t k = begin; k < end; ++k) cancel(system, contacts_[k], substep);
        });
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
        for (const Contact& c : contacts_) cancel(system, c, substep);
    }

    static void cancel(System& system, const Contact& c, const Substep& substep)
    {
        if (normal_velocity(system.bodies, c) < 0)
            system.impacts.add(c, cancel_normal(system.bodies, c), substep.begin);
    }

    int passes_;
    bool started_ = false;
    std::vector<Contact> contacts_;
    ContactLevels levels_;  ///< for ContactOrder::shock
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
