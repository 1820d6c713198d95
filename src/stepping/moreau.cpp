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
#include "stepping/contact_solver.hpp"
#include "stepping/driver.hpp"
#include "stepping/stepping.hpp"

#include <algorithm>
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
        accelerate(system.bodies, system.gravity, substep.length);
        free_ = system.bodies.velocity;
        ahead_.clear();
        solve(system, substep.length);
        for (int round = 1; look_ahead_ && round < sweeps_ && join_ahead(system, substep.length); ++round) {
            if (!system.patience.lasts_for(system.bodies.size())) break;
            system.bodies.velocity = free_;
            solve(system, substep.length);
        }
        report(system, substep);
        move(system.bodies, substep.length);
    }

    void finish(System& system)
    {
        if (!started_) return;
        contacts_.clear();
        detect(system, system.bodies.position);
        system.record(contacts_);
    }

private:
    void detect(System& system, const std::vector<Vec3>& position)
    {
        system.detector.find_pairs(position, system.bodies.radius, contacts_);
        system.detector.find_walls(position, system.bodies.radius, contacts_);
    }

    double velocity_before(const System& system, const Contact& c) const
    {
        const Vec3& a = before_[static_cast<std::size_t>(c.a)];
        return c.normal.dot(system.detector.is_wall(c.b) ? a : Vec3(a - before_[static_cast<std::size_t>(c.b)]));
    }

    void solve(System& system, double h)
    {
        system.arranger.arrange(contacts_);
        rows_.clear();
        for (const Contact& c : contacts_) {
            const double e = law_of(system.bodies, system.laws, c).restitution;
            const double least = e > 0 ? -e * std::min(velocity_before(system, c), 0.0) : -c.gap / h;
            rows_.push_back({c, least, 0});
        }
        solve_contacts(system.bodies, rows_, sweeps_, system.patience);
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
        std::sort(contacts_.begin(), contacts_.end(), [&](const Contact& c, const Contact& d) {
            return std::make_tuple(system.detector.is_wall(c.b), c.a, c.b) <
                   std::make_tuple(system.detector.is_wall(d.b), d.a, d.b);
        });
        return true;
    }

    /// Tangential factors act where bodies meet, not where one lies on the other: a contact that got an impulse in the
    /// step before, too, or that closes no faster than gravity makes it in a step, is support.
    void report(System& system, const Substep& substep)
    {
        const double support = substep.length * std::sqrt(system.gravity.squaredNorm());
        active_.swap(active_before_);
        active_.clear();
        for (const ContactRow& row : rows_) {
            if (row.impulse == 0) continue;
            const Contact& c = row.contact;
            active_.emplace(c.a, c.b);
            Impulse impulse{row.impulse * c.normal, row.impulse};
            if (velocity_before(system, c) < -support && !active_before_.contains({c.a, c.b}))
                impulse.on_a += damp(system.bodies, c, law_of(system.bodies, system.laws, c)).on_a;
            system.impacts.add(c, impulse, substep.begin);
        }
    }

    int sweeps_;
    bool look_ahead_;
    bool started_ = false;
    std::vector<Contact> contacts_;
    std::vector<ContactRow> rows_;
    using Pair = std::pair<BodyId, BodyId>;
    std::set<Pair> active_, active_before_;  ///< contacts that got an impulse in this step, in the one before
    std::vector<Vec3> before_, free_;        ///< velocities: at the start of the step, and without contacts
    std::vector<Vec3> place_;                ///< at the end of the step
    std::set<Pair> ahead_;                   ///< contacts of this step that are open at its start
};

}  // namespace

Outcome run_stepping(const Scene& scene, const Moreau& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, false);
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
