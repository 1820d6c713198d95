/// \file
/// Moreau-Jean: velocities at the end of a step are those that satisfy every contact at once; positions follow.
///
/// Contacts closed at the start of the step: 0 <= impulse _|_ c+ + e min(c-, 0) >= 0, with c- at the start of the step
/// (Moreau 1988; Newton's law of restitution). A closed contact is never moved apart: the overlap in which an impact
/// was seen stays until the bounce leaves it. Where e = 0: 0 <= impulse _|_ c+ + gap/h >= 0, and a contact counts that
/// would be closed at the end of the step, too: it may be approached, not entered. (The first alone would throw a
/// sphere out at gap/h, as fast as it came, when an impact is seen too late. With e > 0 this term would eat the bounce,
/// so it is not there.) Looking ahead is this project's own: contacts that appear at the end of the step, with the
/// velocities found, join until none does.
///
/// With Integrator::parabola the one problem becomes three, so that flight and sliding are exact (this project's own):
/// 1. impact, at the start: c+ >= -e min(c-, 0) for the velocities there;
/// 2. support, a force that lasts the step: v += h g, then c+ >= 0; p += h (v_1 + v_2) / 2 (FreeMotion::move_pushed);
/// 3. where some e = 0, overlaps at the new places: w >= -gap/h, p += h w, and again c+ >= 0.
/// Contacts of 1 and 2 are those closed at the start, of 3 those without restitution that are closed at the end; beside
/// them the others of 1 stay with w >= 0, c+ >= 0, so that no correction pushes them back.
///
/// With ContactOrder::shock each problem is followed by one pass from the ground up, level by level, with those below
/// infinitely heavy (contact_levels.hpp): for what the sweeps left unsolved.
#include "stepping/contact_levels.hpp"
#include "stepping/contact_solver.hpp"
#include "stepping/driver.hpp"
#include "stepping/stepping.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <tuple>
#include <utility>

namespace carom {

namespace {

using namespace stepping;

/// Whether a contact without restitution is possible.
bool any_inelastic(const Scene& scene)
{
    const auto zero = [](const auto& each) { return each.restitution == 0; };
    return std::any_of(scene.materials.begin(), scene.materials.end(), zero) ||
           std::any_of(scene.contacts.begin(), scene.contacts.end(), zero);
}

class MoreauStepper {
public:
    MoreauStepper(const Moreau& method, const Scene& scene) : sweeps_(method.sweeps), look_ahead_(any_inelastic(scene))
    {
    }

    void advance(System& system, const Substep& substep)
    {
        contacts_.clear();
        detect(system, system.bodies.position);
        if (started_) system.record(contacts_);  // the first positions are the scene's, not the method's
        started_ = true;
        before_ = system.bodies.velocity;
        active_.swap(active_before_);
        active_.clear();
        if (system.motion.integrator() == Integrator::parabola)
            advance_on_parabolas(system, substep);
        else
            advance_straight(system, substep);
    }

    void finish(System& system)
    {
        if (!started_) return;
        contacts_.clear();
        detect(system, system.bodies.position);
        system.record(contacts_);
    }

private:
    void advance_straight(System& system, const Substep& substep)
    {
        system.motion.accelerate(system.bodies, substep.length);
        solve_looking_ahead(system, substep.length, [&](const Contact& c) {
            const double e = restitution(system, c);
            return e > 0 ? -e * std::min(velocity_before(system, c), 0.0) : -c.gap / substep.length;
        });
        report_impacts(system, substep);
        system.motion.move_pushed(system.bodies, substep.length);
    }

    void advance_on_parabolas(System& system, const Substep& substep)
    {
        solve(system,
              [&](const Contact& c) { return -restitution(system, c) * std::min(velocity_before(system, c), 0.0); });
        report_impacts(system, substep);
        system.motion.accelerate(system.bodies, substep.length);
        solve(system, [](const Contact&) { return 0.0; });
        report_support(system, substep);
        system.motion.move_pushed(system.bodies, substep.length);
        if (look_ahead_) correct(system, substep);
    }

    /// Stage 3: contacts without restitution that the new places overlap.
    void correct(System& system, const Substep& substep)
    {
        Bodies& bodies = system.bodies;
        const auto bounces = [&](const Contact& c) { return restitution(system, c) > 0; };
        std::erase_if(contacts_, std::not_fn(bounces));
        const std::vector<Contact> bouncing = std::exchange(contacts_, {});
        detect(system, bodies.position);
        std::erase_if(contacts_, bounces);
        if (contacts_.empty()) return;
        contacts_.insert(contacts_.end(), bouncing.begin(), bouncing.end());
        bring_into_order(system);
        std::vector<Vec3> velocity(bodies.size(), Vec3::Zero());
        velocity.swap(bodies.velocity);
        solve_looking_ahead(system, substep.length,
                            [&](const Contact& c) { return bounces(c) ? 0.0 : -c.gap / substep.length; });
        for (std::size_t i = 0; i < bodies.size(); ++i) bodies.position[i] += substep.length * bodies.velocity[i];
        velocity.swap(bodies.velocity);
        solve(system, [](const Contact&) { return 0.0; });
        report_impacts(system, substep);
    }

    void detect(System& system, const std::vector<Vec3>& position)
    {
        system.detector.find_pairs(position, system.bodies.radius, contacts_);
        system.detector.find_walls(position, system.bodies.radius, contacts_);
    }

    static double restitution(const System& system, const Contact& c)
    {
        return law_of(system.bodies, system.laws, c).restitution;
    }

    double velocity_before(const System& system, const Contact& c) const
    {
        const Vec3& a = before_[static_cast<std::size_t>(c.a)];
        return c.normal.dot(system.detector.is_wall(c.b) ? a : Vec3(a - before_[static_cast<std::size_t>(c.b)]));
    }

    /// \param least_of a contact: see ContactRow::least
    template <class LeastOf>
    void solve(System& system, LeastOf&& least_of)
    {
        const bool propagates = system.arranger.order() == ContactOrder::shock;
        if (propagates)
            levels_.arrange(system.bodies, contacts_);
        else
            system.arranger.arrange(contacts_);
        rows_.clear();
        for (const Contact& c : contacts_) rows_.push_back({c, least_of(c), 0});
        solve_contacts(system.bodies, rows_, sweeps_, system.patience);
        if (propagates) propagate(system);
    }

    /// Impulses that are still lacking, given from the ground up, at the cost of what is above.
    void propagate(System& system)
    {
        levels_.propagate(system.bodies, [&](std::size_t begin, std::size_t end) {
            level_rows_.clear();
            for (std::size_t k = begin; k < end; ++k) level_rows_.push_back({rows_[k].contact, rows_[k].least, 0});
            solve_contacts(system.bodies, level_rows_, sweeps_, system.patience);
            for (std::size_t k = begin; k < end; ++k) rows_[k].impulse += level_rows_[k - begin].impulse;
        });
    }

    /// The same, again with the contacts that appear at the end of the step until none does.
    template <class LeastOf>
    void solve_looking_ahead(System& system, double h, LeastOf&& least_of)
    {
        ahead_.clear();
        free_ = system.bodies.velocity;
        solve(system, least_of);
        for (int round = 1; look_ahead_ && round < sweeps_ && join_ahead(system, h); ++round) {
            if (!system.patience.lasts_for(system.bodies.size())) break;
            system.bodies.velocity = free_;
            solve(system, least_of);
        }
    }

    /// Contacts without restitution, open now, that these velocities would close by more than rounding. \return whether
    /// there is one that was not known.
    bool join_ahead(System& system, double h)
    {
        const Bodies& bodies = system.bodies;
        place_.resize(bodies.size());
        for (std::size_t i = 0; i < bodies.size(); ++i) place_[i] = bodies.position[i] + h * bodies.velocity[i];
        const std::vector<Contact> known = std::exchange(contacts_, {});
        detect(system, place_);
        const std::vector<Contact> found = std::exchange(contacts_, known);
        const std::size_t count = contacts_.size();
        for (const Contact& c : found) {
            if (law_of(bodies, system.laws, c).restitution > 0) continue;
            const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
            const Gap now =
                system.detector.is_wall(c.b)
                    ? wall_gap(system.detector.wall(c.b), bodies.position[a], bodies.radius[a])
                    : sphere_gap(bodies.position[a], bodies.position[b], bodies.radius[a] + bodies.radius[b]);
            if (now.value > 0 && ahead_.emplace(c.a, c.b).second)
                contacts_.push_back({now.value, c.a, c.b, now.normal});
        }
        if (contacts_.size() == count) return false;
        bring_into_order(system);
        return true;
    }

    /// Index order, in which ContactArranger wants them.
    void bring_into_order(const System& system)
    {
        std::sort(contacts_.begin(), contacts_.end(), [&](const Contact& c, const Contact& d) {
            return std::make_tuple(system.detector.is_wall(c.b), c.a, c.b) <
                   std::make_tuple(system.detector.is_wall(d.b), d.a, d.b);
        });
    }

    /// Tangential factors act where bodies meet, not where one lies on the other: a contact that got an impulse in the
    /// step before, too, or that closes no faster than gravity makes it in a step, is support.
    void report_impacts(System& system, const Substep& substep)
    {
        const double support = substep.length * std::sqrt(system.motion.gravity().squaredNorm());
        for (const ContactRow& row : rows_) {
            if (row.impulse == 0) continue;
            const Contact& c = row.contact;
            const bool is_new = active_.emplace(c.a, c.b).second && !active_before_.contains({c.a, c.b});
            Impulse impulse{row.impulse * c.normal, row.impulse};
            if (velocity_before(system, c) < -support && is_new)
                impulse.on_a += damp(system.bodies, c, law_of(system.bodies, system.laws, c)).on_a;
            system.impacts.add(c, impulse, substep.begin);
        }
    }

    void report_support(System& system, const Substep& substep)
    {
        for (const ContactRow& row : rows_) {
            if (row.impulse == 0) continue;
            active_.emplace(row.contact.a, row.contact.b);
            system.impacts.add(row.contact, {row.impulse * row.contact.normal, row.impulse}, substep.begin);
        }
    }

    int sweeps_;
    bool look_ahead_;
    bool started_ = false;
    std::vector<Contact> contacts_;
    std::vector<ContactRow> rows_;
    ContactLevels levels_;                ///< for ContactOrder::shock
    std::vector<ContactRow> level_rows_;  ///< of one level
    using Pair = std::pair<BodyId, BodyId>;
    std::set<Pair> active_, active_before_;  ///< contacts that got an impulse in this step, in the one before
    std::vector<Vec3> before_, free_;        ///< velocities: at the start of the step, and before the last solution
    std::vector<Vec3> place_;                ///< at the end of the step
    std::set<Pair> ahead_;                   ///< contacts of this step that are open at its start
};

}  // namespace

Outcome run_stepping(const Scene& scene, const Moreau& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, method.integrator == Integrator::parabola);
    if (method.sweeps < 1) {
        Outcome outcome;
        outcome.status = Status::unresolved;
        outcome.message = "sweeps must be at least 1, is " + std::to_string(method.sweeps);
        return collect(system, outcome);
    }
    MoreauStepper stepper(method, scene);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
