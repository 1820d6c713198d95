/// \file
/// Soft contacts in substeps with relaxation, the solver of Box2D 3 ("soft step", "TGS soft": Catto, Solver2D, 2024;
/// box2d/src/contact_solver.c and solver.c of 3.0 and 3.1). Contacts are looked for once a step, ahead of their paths.
/// Each substep: gravity; the impulses of the substep before; one pass over the contacts, an open one as c >= -s/h, an
/// overlap as a damped spring of `hertz` and `damping_ratio` that parts the two no faster than `push_out` allows;
/// motion; one pass without the springs ("relax"), c >= 0, so that parting leaves no velocity. After the last substep:
/// one pass for restitution, from the closing speeds at the start of the step. `passes` has no meaning here.
///
/// Other than in Box2D: paths are looked along however fast they are, where Box2D looks ahead by 2 cm and lets fast
/// bodies and static ones meet by times of impact; the speed below which nothing rebounds is what gravity gives in a
/// step, where Box2D has 1 m/s; the fastest push apart is `push_out` diameters a period, where Box2D has 3 m/s.
///
/// With Integrator::parabola what meets nothing flies on its parabola, and what has an impulse goes as with euler
/// (FreeMotion::move_struck): the impulses that a contact at rest begins with stay those of a whole substep.
#include "stepping/driver.hpp"
#include "stepping/impulse_memory.hpp"
#include "stepping/path_search.hpp"
#include "stepping/soft_constraint.hpp"
#include "stepping/stepping.hpp"
#include "stepping/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

using namespace stepping;

struct SoftRow {
    Contact contact;     ///< as it was at the start of the step
    Softness softness;   ///< while it overlaps
    double closing = 0;  ///< normal velocity at the start of the step [length/time]
    double impulse = 0;  ///< of this substep, >= 0 [mass length/time]
    double total = 0;    ///< of the step [mass length/time]
    double restitution = 0;
};

/// Smallest diameter of what can move, 0 if nothing can [length].
double smallest_diameter(const Scene& scene)
{
    double radius = std::numeric_limits<double>::infinity();
    for (const Sphere& s : scene.spheres)
        if (!s.fixed) radius = std::min(radius, s.radius);
    return std::isfinite(radius) ? 2 * radius : 0;
}

class SoftStepper {
public:
    SoftStepper(const Soft& method, const Scene& scene)
        : hertz_(std::min(method.hertz, fastest_softness * method.substeps / method.dt)),
          damping_ratio_(method.damping_ratio),
          push_speed_(push_out * smallest_diameter(scene) * method.hertz),
          substeps_(method.substeps),
          search_(scene.spheres.size())
    {
    }

    void advance(System& system, const Substep& substep)
    {
        if (substep_ == 0) begin_step(system, substep);
        const double h = substep.length;
        system.motion.accelerate(system.bodies, h);
        for (SoftRow& row : rows_) give(system, row, row.impulse);
        for (SoftRow& row : rows_) solve(system, row, h, true);
        system.motion.move_struck(system.bodies, h);
        for (SoftRow& row : rows_) solve(system, row, h, false);
        for (const SoftRow& row : rows_)
            system.max_penetration = std::max(system.max_penetration, -gap_now(system, row.contact));
        reached_ = substep.end;
        if (++substep_ < substeps_) return;
        substep_ = 0;
        memory_.keep(rows_, [this](const SoftRow& row) { return row.closing >= -threshold_; });
        for (SoftRow& row : rows_) restitute(system, row);
        report(system, reached_);
    }

    void finish(System& system)
    {
        if (substep_ > 0) report(system, reached_);
    }

private:
    void begin_step(System& system, const Substep& substep)
    {
        const double length = substeps_ * substep.length, gravity = std::sqrt(system.motion.gravity().squaredNorm());
        const Bodies& bodies = system.bodies;
        threshold_ = gravity * length;
        start_ = bodies.position;
        contacts_.clear();
        search_.find(bodies, system.detector, {.time = length, .bend = gravity * length * length}, contacts_);
        system.arranger.arrange(contacts_);
        rows_.clear();
        for (const Contact& c : contacts_) {
            SoftRow row;
            row.contact = c;
            const double hertz = is_against_ground(system, c) ? static_stiffening * hertz_ : hertz_;
            row.softness = make_softness(hertz, damping_ratio_, substep.length);
            row.closing = normal_velocity(bodies, c);
            row.impulse = memory_.recall(c);
            row.restitution = law_of(bodies, system.laws, c).restitution;
            rows_.push_back(row);
        }
    }

    static bool is_against_ground(const System& system, const Contact& c)
    {
        return system.detector.is_wall(c.b) || system.detector.is_fixed(static_cast<std::size_t>(c.a)) ||
               system.detector.is_fixed(static_cast<std::size_t>(c.b));
    }

    static double gap_now(const System& system, const Contact& c)
    {
        const Bodies& bodies = system.bodies;
        const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
        return system.detector.is_wall(c.b)
                   ? wall_gap(system.detector.wall(c.b), bodies.position[a], bodies.radius[a]).value
                   : sphere_gap(bodies.position[a], bodies.position[b], bodies.radius[a] + bodies.radius[b]).value;
    }

    /// The gap along the normal that the step began with [length].
    double separation(const System& system, const Contact& c) const
    {
        const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
        Vec3 moved = system.bodies.position[a] - start_[a];
        if (!system.detector.is_wall(c.b)) moved -= system.bodies.position[b] - start_[b];
        return c.gap + c.normal.dot(moved);
    }

    static void give(System& system, SoftRow& row, double impulse)
    {
        apply(system.bodies, row.contact, impulse * row.contact.normal);
        row.total += impulse;
    }

    /// Raise the impulse of the substep by this much, or lower it, to 0 at least.
    static void add(System& system, SoftRow& row, double impulse)
    {
        const double sum = std::max(row.impulse + impulse, 0.0);
        const double added = sum - row.impulse;
        row.impulse = sum;
        give(system, row, added);
    }

    void solve(System& system, SoftRow& row, double h, bool with_springs)
    {
        const double s = separation(system, row.contact), mass = effective_mass(system.bodies, row.contact);
        const double speed = normal_velocity(system.bodies, row.contact);
        if (s > 0) {
            add(system, row, -mass * (speed + s / h));
        } else if (with_springs) {
            const double bias = std::max(row.softness.bias_rate * s, -push_speed_);
            add(system, row,
                -mass * row.softness.mass_scale * (speed + bias) - row.softness.impulse_scale * row.impulse);
        } else {
            add(system, row, -mass * speed);
        }
    }

    bool has_struck(const SoftRow& row) const { return row.total > 0 && row.closing < -threshold_; }

    void restitute(System& system, SoftRow& row) const
    {
        if (!has_struck(row) || row.restitution == 0) return;
        const double lacking = -row.restitution * row.closing - normal_velocity(system.bodies, row.contact);
        add(system, row, effective_mass(system.bodies, row.contact) * lacking);
    }

    void report(System& system, double now)
    {
        for (const SoftRow& row : rows_) {
            if (!(row.total > 0)) continue;
            const Contact& c = row.contact;
            Impulse impulse{row.total * c.normal, row.total};
            if (has_struck(row)) impulse.on_a += damp(system.bodies, c, law_of(system.bodies, system.laws, c)).on_a;
            system.impacts.add(c, impulse, now);
        }
        rows_.clear();
    }

    double hertz_, damping_ratio_;
    double push_speed_;  ///< [length/time]
    int substeps_;
    int substep_ = 0;       ///< number of the one to come, in its step
    double threshold_ = 0;  ///< closing speed up to which nothing rebounds [length/time]
    double reached_ = 0;    ///< end of the last substep [time]
    PathSearch search_;
    ImpulseMemory memory_;
    std::vector<Vec3> start_;  ///< positions at the start of the step
    std::vector<Contact> contacts_;
    std::vector<SoftRow> rows_;
};

}  // namespace

Outcome run_stepping(const Scene& scene, const Soft& method, const RunOptions& options, const Observer& observer)
{
    System system(scene, method, observer, false);
    if (!(method.hertz > 0) || !std::isfinite(method.hertz))
        return refuse(system, "hertz must be > 0 and finite, is " + text(method.hertz));
    if (!(method.damping_ratio >= 0) || !std::isfinite(method.damping_ratio))
        return refuse(system, "damping ratio must be >= 0 and finite, is " + text(method.damping_ratio));
    SoftStepper stepper(method, scene);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
