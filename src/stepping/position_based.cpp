/// \file
/// Position based: move, then, contact by contact, respond and project the overlap away. All pairs in one pass, each
/// tested where those before it have left it, then all walls in the same way. Later contacts may undo earlier
/// corrections: the result is good for the last constraints visited, the walls. (Name: Mueller, Heidelberger, Hennix,
/// Ratcliff, Position based dynamics, 2007.)
///
/// ContactOrder::jacobi: only what overlaps before the first correction of a phase is visited, in index order; a pair
/// that a correction pushes together waits for the next pass or step.
#include "stepping/driver.hpp"
#include "stepping/pair_pass.hpp"
#include "stepping/pass_order.hpp"
#include "stepping/stepping.hpp"

#include <algorithm>
#include <array>

namespace carom {

namespace {

using namespace stepping;

class PositionStepper {
public:
    PositionStepper(const PositionBased& method, const std::vector<double>& radius)
        : method_(method), pass_(radius), was_projected_(radius.size(), 0)
    {
    }

    void advance(System& system, const Substep& substep)
    {
        system.motion.fly(system.bodies, substep.length);  // A
        for (int pass = 0; pass < method_.passes && !system.patience.ended(); ++pass) {
            detect(system, pass == 0);
            const Response response{pass == 0 || !method_.literal, substep.end};
            between_spheres(system, response);  // B
            find_walls_again(system, pass == 0);
            at_walls(system, response);  // C
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

    struct Response {
        bool is_due;  ///< velocities are updated in this pass
        double time;  ///< of its events
    };

    void update_velocity(System& system, const Contact& c, const Response& response)
    {
        if (!response.is_due) return;
        if (method_.literal || normal_velocity(system.bodies, c) < 0)
            system.impacts.add(c, respond(system.bodies, system.laws, c), response.time);
    }

    void between_spheres(System& system, const Response& response)
    {
        if (method_.order != ContactOrder::jacobi) {
            pass_.run(system, pairs_, [&](const Contact& c) { correct_pair(system, c, response); });
            return;
        }
        const Bodies& bodies = system.bodies;
        for (Contact& c : pairs_) {
            const std::size_t a = index(c.a), b = index(c.b);
            const Gap gap = sphere_gap(bodies.position[a], bodies.position[b], bodies.radius[a] + bodies.radius[b]);
            if (gap.value > 0) continue;  // an earlier projection has parted them
            correct_pair(system, {gap.value, c.a, c.b, gap.normal}, response);
        }
    }

    void correct_pair(System& system, const Contact& c, const Response& response)
    {
        Bodies& bodies = system.bodies;
        const std::size_t a = index(c.a), b = index(c.b);
        update_velocity(system, c, response);
        const double share_a = share(bodies.inverse_mass[a], bodies.inverse_mass[b]);
        bodies.position[a] -= (share_a * c.gap) * c.normal;
        bodies.position[b] += ((1 - share_a) * c.gap) * c.normal;
        note_projected(c.a);
        note_projected(c.b);
    }

    /// Share of a in a projection: half, or by inverse mass; beside a fixed sphere all of it.
    double share(double inverse_a, double inverse_b) const
    {
        const bool weighted = method_.mass_weighted || inverse_a == 0 || inverse_b == 0;
        return weighted ? inverse_a / (inverse_a + inverse_b) : 0.5;
    }

    void at_walls(System& system, const Response& response)
    {
        list_visits_of_walls(system);
        for (const Visit& visit : visits_) {
            const std::size_t a = index(visit.a);
            const Vec3& p = system.bodies.position[a];
            const Wall& wall = system.detector.wall(visit.b);
            if (!overlap(wall, p, system.bodies.radius[a])) continue;
            const Gap gap = wall_gap(wall, p, system.bodies.radius[a]);
            update_velocity(system, {gap.value, visit.a, visit.b, gap.normal}, response);
            system.bodies.position[a] -= gap.value * gap.normal;
        }
    }

    /// All walls of each sphere that touches one: a projection off one may bring it into another. Spheres do not change
    /// each other here, so those that touch none are done.
    void list_visits_of_walls(System& system)
    {
        const PassOrder order(system.arranger);
        visits_.clear();
        BodyId listed = no_body;
        for (const Contact& c : walls_) {
            if (method_.order == ContactOrder::jacobi) {
                visits_.push_back(order.visit(c.a, c.b, c.gap));
                continue;
            }
            if (c.a == listed) continue;
            listed = c.a;
            const std::size_t a = index(c.a);
            const auto all = static_cast<BodyId>(system.bodies.size() + system.detector.walls());
            for (auto b = static_cast<BodyId>(system.bodies.size()); b < all; ++b) {
                const double gap =
                    wall_gap(system.detector.wall(b), system.bodies.position[a], system.bodies.radius[a]).value;
                visits_.push_back(order.visit(c.a, b, gap));
            }
        }
        if (!std::is_sorted(visits_.begin(), visits_.end())) std::sort(visits_.begin(), visits_.end());
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
    PairPass pass_;
    std::vector<Contact> pairs_, walls_;
    std::vector<Visit> visits_;      ///< of spheres at walls
    std::vector<BodyId> projected_;  ///< by phase B of this pass
    std::vector<std::uint8_t> was_projected_;
};

}  // namespace

Outcome run_stepping(const Scene& scene, const PositionBased& method, const RunOptions& options,
                     const Observer& observer)
{
    System system(scene, method, observer, method.passes > 1);
    PositionStepper stepper(method, system.bodies.radius);
    return drive(scene, method, options, observer, system, stepper);
}

}  // namespace carom
