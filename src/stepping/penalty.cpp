/// \file
/// Penalty: bodies overlap, and a spring and a damper push them apart while they do (Moore, Wilhelms, Collision
/// detection and response for computer animation, Computer Graphics 22(4), 1988). Forces of all contacts are those of
/// one state, so the order of contacts does not matter. A contact takes time, and what is in it is soft.
///
/// The damper of a contact is that of its restitution (contact_spring.hpp), without a rule against pulling: near the
/// end of a contact the damper holds back more than the spring pushes, and the formula counts on it. Without a
/// stiffness each contact gets that with which two bodies alone stay in contact for `steps_in_contact` substeps.
///
/// Integrator::euler: forces at the start of the substep, v += h (g + f/m), p += h v. Integrator::parabola: leapfrog,
/// half of the forces before and half after the motion, so that flight is exact; the damper sees the velocities in the
/// middle.
#include "stepping/contact_spring.hpp"
#include "stepping/driver.hpp"
#include "stepping/stepping.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace carom {

namespace {

using namespace stepping;

class PenaltyStepper {
public:
    explicit PenaltyStepper(const Penalty& method)
        : stiffness_(method.stiffness),
          frequency_(std::numbers::pi * method.substeps / (steps_in_contact * method.dt)),
          is_leapfrog_(method.integrator == Integrator::parabola)
    {
    }

    void advance(System& system, const Substep& substep)
    {
        const double h = substep.length;
        if (!is_leapfrog_ || !started_) find_forces(system);
        started_ = true;
        const double before = system.motion.resist_before(system.bodies, h);
        push(system, before, substep.begin);
        system.motion.fall_before(system.bodies, before);
        system.motion.drift(system.bodies, h);
        if (!is_leapfrog_) return;
        find_forces(system);
        const double after = system.motion.resist_after(system.bodies, h);
        push(system, after, substep.end);
        system.motion.fall_after(system.bodies, after);
    }

    void finish(System& system)
    {
        if (started_ && !is_leapfrog_) find_forces(system);
    }

private:
    using Pair = std::pair<BodyId, BodyId>;
    struct Force {
        Contact contact;
        double normal;  ///< [mass length/time^2]
        bool begins;    ///< no force was between the two before, and they approach
    };

    /// Values for the present positions and velocities.
    void find_forces(System& system)
    {
        contacts_.clear();
        system.detector.find_pairs(system.bodies.position, system.bodies.radius, contacts_);
        system.detector.find_walls(system.bodies.position, system.bodies.radius, contacts_);
        if (started_) system.record(contacts_);  // the first positions are the scene's, not the method's
        active_.swap(active_before_);
        active_.clear();
        forces_.clear();
        for (const Contact& c : contacts_) {
            const double mass = effective_mass(system.bodies, c), speed = normal_velocity(system.bodies, c);
            const double omega = stiffness_ ? std::sqrt(*stiffness_ / mass) : frequency_;
            const double zeta = damping_ratio(law_of(system.bodies, system.laws, c).restitution);
            const double normal = mass * omega * (-omega * c.gap - 2 * zeta * speed);
            const Pair pair{c.a, c.b};
            const bool is_new = !std::binary_search(active_before_.begin(), active_before_.end(), pair);
            forces_.push_back({c, normal, is_new && speed < 0});
            active_.push_back(pair);
        }
        std::sort(active_.begin(), active_.end());
    }

    /// Let the forces act for a time. A contact is reported when it begins, with what it gets then.
    void push(System& system, double duration, double now)
    {
        for (Force& force : forces_) {
            const double normal = duration * force.normal;
            Impulse impulse{normal * force.contact.normal, normal};
            apply(system.bodies, force.contact, impulse.on_a);
            if (std::exchange(force.begins, false)) {
                const ContactLaw& law = law_of(system.bodies, system.laws, force.contact);
                impulse.on_a += damp(system.bodies, force.contact, law).on_a;
                system.impacts.add(force.contact, impulse, now);
            } else {
                system.impacts.press(force.contact, normal);
            }
        }
    }

    std::optional<double> stiffness_;  ///< of all contacts [mass/time^2]
    double frequency_;                 ///< omega of each contact, if there is no common stiffness [1/time]
    bool is_leapfrog_;
    bool started_ = false;
    std::vector<Contact> contacts_;
    std::vector<Force> forces_;
    std::vector<Pair> active_, active_before_;  ///< contacts with a force now, and at the look before; sorted
};

/// The fastest spring that the scene may have.
struct StiffestContact {
    double mass = std::numeric_limits<double>::infinity();  ///< reduced, the least of two bodies of the scene [mass]
    double damping = 0;                                     ///< zeta, the largest of two bodies of the scene
};

StiffestContact stiffest_contact(const Scene& scene)
{
    StiffestContact stiffest;
    std::vector<double> masses;
    bool has_ground = !scene.planes.empty();
    for (const Sphere& s : scene.spheres)
        if (s.fixed)
            has_ground = true;
        else
            masses.push_back(s.mass);
    std::sort(masses.begin(), masses.end());
    if (has_ground && !masses.empty())
        stiffest.mass = masses[0];
    else if (masses.size() > 1)
        stiffest.mass = 1 / (1 / masses[0] + 1 / masses[1]);
    std::vector<int> materials;
    for (const Sphere& s : scene.spheres) materials.push_back(s.material);
    std::sort(materials.begin(), materials.end());
    materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
    const auto consider = [&](const ContactLaw& law) {
        stiffest.damping = std::max(stiffest.damping, damping_ratio(law.restitution));
    };
    for (const int a : materials) {
        for (const int b : materials) consider(sphere_contact_law(scene, a, b));
        for (const Plane& p : scene.planes) consider(plane_contact_law(scene, a, p.material));
    }
    return stiffest;
}

/// Problem of the stiffness, empty if there is none.
std::string stiffness_problem(const Scene& scene, const Penalty& method)
{
    if (!method.stiffness) return "";
    const double k = *method.stiffness;
    if (!(k > 0) || !std::isfinite(k)) return "stiffness must be > 0 and finite, is " + text(k);
    const StiffestContact stiffest = stiffest_contact(scene);
    const double longest = stable_step(std::sqrt(k / stiffest.mass), stiffest.damping);
    const double h = method.dt / method.substeps;
    if (!(h > longest)) return "";
    const double softer = h / longest;
    return "a substep of " + text(h) + " is longer than " + text(longest) + ", the stable step of a stiffness of " +
           text(k) + " at a reduced mass of " + text(stiffest.mass) +
           ": springs would gain energy (take dt <= " + text(longest * method.substeps) +
           ", more substeps, or a stiffness <= " + text(k / (softer * softer)) + ")";
}

}  // namespace

Outcome run_stepping(const Scene& scene, const Penalty& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, false);
    const std::string problem = stiffness_problem(scene, method);
    if (!problem.empty()) return refuse(system, problem);
    PenaltyStepper stepper(method);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
