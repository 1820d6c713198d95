/// \file
/// Position based: move, then, contact by contact, respond and project the overlap away. Later contacts may undo
/// earlier corrections: the result is good for the last constraints visited, the walls. (Name: Mueller, Heidelberger,
/// Hennix, Ratcliff, Position based dynamics, 2007.)
#include "stepping/driver.hpp"
#include "stepping/stepping.hpp"

#include <algorithm>

namespace carom {

namespace {

using namespace stepping;

class PositionStepper {
public:
    PositionStepper(const PositionBased& method, std::size_t spheres) : method_(method), was_projected_(spheres, 0) {}

    void advance(System& system, const Substep& substep)
    {
        system.motion.fly(system.bodies, substep.length);  // A
        for (int pass = 0; pass < method_.passes && !system.patience.ended(); ++pass) {
            detect(system, pass == 0);
            const bool respond_now = pass == 0 || !method_.literal;
            between_spheres(system, substep, respond_now);  // B
            find_walls_again(system, pass == 0);
            at_walls(system, substep, respond_now);  // C
            system.patience.lasts_for(system.bodies.size() + pairs_.size() + walls_.size());
        }
    }

    void finish(System&) {}

private:
    static std::size_t index(BodyId body) { return static_cast<std::size_t>(body); }

    /// Contacts after phase A. Walls are looked for here already, before phase B corrects anything, for the record.
    void detect(System& system, bool first)
    {
        pairs_.clear();
        system.detector.find_pairs(system.bodies.position, system.bodies.radius, pairs_);
        if (!first) return;
        walls_.clear();
        system.detector.find_walls(system.bodies.position, system.bodies.radius, walls_);
        system.record(pairs_);
        system.record(walls_);
    }

    void update_velocity(System& system, const Contact& c, double time)
    {
        if (method_.literal || normal_velocity(system.bodies, c) < 0)
            system.impacts.add(c, respond(system.bodies, system.laws, c), time);
    }

    void between_spheres(System& system, const Substep& substep, bool respond_now)
    {
        Bodies& bodies = system.bodies;
        system.arranger.arrange(pairs_);
        for (Contact& c : pairs_) {
            const std::size_t a = index(c.a), b = index(c.b);
            const Gap gap = sphere_gap(bodies.position[a], bodies.position[b], bodies.radius[a] + bodies.radius[b]);
            if (gap.value > 0) continue;  // an earlier projection has parted them
            c.normal = gap.normal;
            if (respond_now) update_velocity(system, c, substep.end);
            const double share_a = share(bodies.inverse_mass[a], bodies.inverse_mass[b]);
            bodies.position[a] -= (share_a * gap.value) * gap.normal;
            bodies.position[b] += ((1 - share_a) * gap.value) * gap.normal;
            note_projected(c.a);
            note_projected(c.b);
        }
    }

    /// What a takes of a projection: half, or by inverse mass; beside a fixed sphere all of it.
    double share(double inverse_a, double inverse_b) const
    {
        const bool weighted = method_.mass_weighted || inverse_a == 0 || inverse_b == 0;
        return weighted ? inverse_a / (inverse_a + inverse_b) : 0.5;
    }

    void at_walls(System& system, const Substep& substep, bool respond_now)
    {
        Bodies& bodies = system.bodies;
        system.arranger.arrange(walls_);
        for (Contact& c : walls_) {
            const std::size_t a = index(c.a);
            const Gap gap = wall_gap(system.detector.wall(c.b), bodies.position[a], bodies.radius[a]);
            if (gap.value > 0) continue;
            c.normal = gap.normal;
            if (respond_now) update_velocity(system, c, substep.end);
            bodies.position[a] -= gap.value * gap.normal;
        }
    }

    void note_projected(BodyId sphere)
    {
        if (was_projected_[index(sphere)]) return;
        was_projected_[index(sphere)] = 1;
        projected_.push_back(sphere);
    }

    /// Walls as phase B left the spheres: in the first pass only those that it projected can have changed.
    void find_walls_again(System& system, bool first)
    {
        const Bodies& bodies = system.bodies;
        if (first) {
            std::erase_if(walls_, [this](const Contact& c) { return was_projected_[index(c.a)] != 0; });
            const std::size_t kept = walls_.size();
            for (const BodyId i : projected_)
                system.detector.find_walls_of(i, bodies.position[index(i)], bodies.radius[index(i)], walls_);
            if (walls_.size() > kept)
                std::sort(walls_.begin(), walls_.end(),
                          [](const Contact& x, const Contact& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
        } else {
            walls_.clear();
            system.detector.find_walls(bodies.position, bodies.radius, walls_);
        }
        for (const BodyId i : projected_) was_projected_[index(i)] = 0;
        projected_.clear();
    }

    const PositionBased& method_;
    std::vector<Contact> pairs_, walls_;
    std::vector<BodyId> projected_;  ///< by phase B of this pass
    std::vector<std::uint8_t> was_projected_;
};

}  // namespace

Outcome run_stepping(const Scene& scene, const PositionBased& method, const RunOptions& options,
                     const Observer& observer)
{
    System system(scene, method, observer, method.passes > 1);
    PositionStepper stepper(method, scene.spheres.size());
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
