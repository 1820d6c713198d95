/// \file
/// Speculative contacts: whatever a path comes near to within the step gets a velocity constraint, c >= -gap/h, so that
/// the gap may close but not be passed; sequential impulses solve all of them, begun with those of the step before;
/// then all move; then those that closed faster than they were let rebound (Catto, Box2D; Firth, Speculative contacts,
/// 2011; Jolt; PhysX). Whatever these velocities now come near to joins (engines leave that to the next step). Nothing
/// fast passes through anything thin. The rest of the step after a contact is lost, and the constraint is that of a
/// plane through the nearest point: a sphere that would have passed beside another is stopped.
///
/// The choice of what rebounds is this project's own: velocities at the end of the step are those of one
/// complementarity problem, 0 <= impulse _|_ c+ + e min(c-, 0) >= 0, for the contacts that were needed and that closed
/// or rested at the start of the step (c- <= |g| h). So equal restitutions of 1 keep the energy. A contact that opened,
/// and closed only because another one struck within the step, loses its impulse again: it is met as an impact in the
/// step to come. An overlap is parted by `overlap_recovery` of it a step, and that leaves no velocity.
///
/// Velocities are those with which the step is made (FreeMotion::kick_before): with Integrator::parabola the mean ones,
/// so that flight is exact and gaps close as planned.
#include "stepping/contact_solver.hpp"
#include "stepping/driver.hpp"
#include "stepping/impulse_memory.hpp"
#include "stepping/path_search.hpp"
#include "stepping/stepping.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom {

namespace {

using namespace stepping;

class SpeculativeStepper {
public:
    SpeculativeStepper(const Speculative& method, std::size_t spheres) : sweeps_(method.sweeps), search_(spheres) {}

    void advance(System& system, const Substep& substep)
    {
        const double h = substep.length;
        Bodies& bodies = system.bodies;
        before_ = bodies.velocity;
        support_ = h * std::sqrt(system.motion.gravity().squaredNorm());
        system.motion.kick_before(bodies, h);
        look(system, h);
        plan(system, h);
        system.motion.drift(bodies, h);
        system.motion.kick_after(bodies, h);
        rebound(system, substep);
    }

    void finish(System& system)
    {
        if (started_) look(system, 0);
    }

private:
    using Pair = std::pair<BodyId, BodyId>;

    void look(System& system, double time)
    {
        contacts_.clear();
        search_.find(system.bodies, system.detector, {.time = time}, contacts_);
        if (started_) system.record(contacts_);  // the first positions are the scene's, not the method's
        started_ = true;
    }

    /// Velocities with which no gap is passed. Those that were not ahead of the free paths, but are ahead of these,
    /// join until there is none.
    void plan(System& system, double h)
    {
        rows_.clear();
        known_.clear();
        for (int round = 0; round < sweeps_ && join(system, h); ++round) {
            solve(system);
            const bool pushes =
                std::any_of(rows_.begin(), rows_.end(), [](const ContactRow& row) { return row.impulse > 0; });
            if (!pushes || system.patience.ended()) break;
            contacts_.clear();
            search_.find(system.bodies, system.detector, {.time = h}, contacts_);
        }
        memory_.keep(rows_, [&](const ContactRow& row) { return !has_struck(system, row.contact); });
    }

    /// Give each contact that has no row one. \return whether there is one
    bool join(System& system, double h)
    {
        std::erase_if(contacts_, [this](const Contact& c) {
            return std::binary_search(known_.begin(), known_.end(), Pair{c.a, c.b});
        });
        system.arranger.arrange(contacts_);
        for (const Contact& c : contacts_) {
            const double least = (c.gap > 0 ? -c.gap : -overlap_recovery * c.gap) / h;
            rows_.push_back({c, least, memory_.recall(c)});
            apply(system.bodies, c, rows_.back().impulse * c.normal);
            known_.emplace_back(c.a, c.b);
        }
        std::sort(known_.begin(), known_.end());
        return !contacts_.empty();
    }

    /// From the impulses that the rows have, to what their changes leave of the speeds that these give.
    void solve(System& system)
    {
        double scale = 0;
        for (const ContactRow& row : rows_)
            scale = std::max(scale, row.impulse / effective_mass(system.bodies, row.contact));
        solve_contacts(system.bodies, rows_, sweeps_, system.patience, scale);
    }

    double velocity_before(const System& system, const Contact& c) const
    {
        const Vec3& a = before_[static_cast<std::size_t>(c.a)];
        return c.normal.dot(system.detector.is_wall(c.b) ? a : Vec3(a - before_[static_cast<std::size_t>(c.b)]));
    }

    /// Velocities at the end of the step.
    void rebound(System& system, const Substep& substep)
    {
        let_go_of_opened(system);
        added_ = rows_;
        for (ContactRow& row : rows_) {
            const Contact& c = row.contact;
            row.least = law_of(system.bodies, system.laws, c).restitution * std::max(-velocity_before(system, c), 0.0);
            const double guess = memory_after_.recall(c);
            apply(system.bodies, c, guess * c.normal);
            row.impulse += guess;
        }
        solve(system);
        for (std::size_t k = 0; k < rows_.size(); ++k) added_[k].impulse = rows_[k].impulse - added_[k].impulse;
        memory_after_.keep(added_, [&](const ContactRow& row) { return !has_struck(system, row.contact); });
        report(system, substep);
    }

    /// Rows that were needed, of contacts that closed or rested before, are kept.
    void let_go_of_opened(System& system)
    {
        std::erase_if(rows_, [&](const ContactRow& row) {
            if (row.impulse == 0) return true;
            if (velocity_before(system, row.contact) <= support_) return false;
            apply(system.bodies, row.contact, -row.impulse * row.contact.normal);
            return true;
        });
    }

    /// Whether it closed faster than gravity makes it in a step.
    bool has_struck(const System& system, const Contact& c) const { return velocity_before(system, c) < -support_; }

    /// Tangential factors act where bodies meet, not where one lies on the other: see moreau.cpp.
    void report(System& system, const Substep& substep)
    {
        active_.swap(active_before_);
        active_.clear();
        for (const ContactRow& row : rows_) {
            const Contact& c = row.contact;
            active_.emplace_back(c.a, c.b);
            if (row.impulse == 0) continue;
            Impulse impulse{row.impulse * c.normal, row.impulse};
            if (has_struck(system, c) &&
                !std::binary_search(active_before_.begin(), active_before_.end(), active_.back()))
                impulse.on_a += damp(system.bodies, c, law_of(system.bodies, system.laws, c)).on_a;
            system.impacts.add(c, impulse, substep.end);
        }
        std::sort(active_.begin(), active_.end());
    }

    int sweeps_;
    bool started_ = false;
    double support_ = 0;  ///< speed that gravity gives in this step [length/time]
    PathSearch search_;
    ImpulseMemory memory_;        ///< of the impulses that let no gap be passed
    ImpulseMemory memory_after_;  ///< of those that came on top
    std::vector<Vec3> before_;    ///< velocities at the start of the step
    std::vector<Contact> contacts_;
    std::vector<ContactRow> rows_;
    std::vector<ContactRow> added_;             ///< what came on top of the impulses that let no gap be passed
    std::vector<Pair> known_;                   ///< contacts that have a row; sorted
    std::vector<Pair> active_, active_before_;  ///< contacts that were needed, now and in the step before; sorted
};

}  // namespace

Outcome run_stepping(const Scene& scene, const Speculative& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, false);
    if (method.sweeps < 1) return refuse(system, "sweeps must be at least 1, is " + std::to_string(method.sweeps));
    SpeculativeStepper stepper(method, scene.spheres.size());
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
