/// \file
/// Contacts that stay closed: in them bodies press on each other and do not bounce.
#pragma once

#include "stepping/step_paths.hpp"
#include "stepping/system.hpp"

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace carom::stepping {

using BodyPair = std::pair<BodyId, BodyId>;  ///< the smaller id first, planes last

/// They act on accelerations: what presses a sphere against its partner is taken away, the rest goes on, so that a ball
/// at rest stays and one that slides on a plane does so on an exact parabola. (Between spheres the gap is kept to
/// second order in the step.) What still closes in them does not rebound.
class RestingContacts {
public:
    explicit RestingContacts(std::size_t spheres) : partners_(spheres) {}

    bool has(BodyId a, BodyId b) const { return forces_.contains({a, b}); }
    /// Calls visit(a, b), a < b, for each.
    template <class Visit>
    void for_each(Visit&& visit) const
    {
        for (const auto& [pair, force] : forces_) visit(pair.first, pair.second);
    }
    /// Partners of a sphere, also planes.
    const std::vector<BodyId>& of(BodyId sphere) const { return partners_[static_cast<std::size_t>(sphere)]; }
    void add(const System& system, BodyId a, BodyId b);
    void remove(const System& system, BodyId a, BodyId b);

    /// At the begin of a substep of length h: forgets what has come apart or is not pressed any more, takes overlap and
    /// closing speed from the others, and gives all spheres the accelerations with which they stay closed.
    /// \param closed other contacts that the substep before left overlapping
    void support_all(System& system, StepPaths& paths, double h, const std::set<BodyPair>& closed);
    /// Within a substep: accelerations for these spheres, while all others keep theirs. \pre all have states of one
    /// moment, to first order
    void support(System& system, StepPaths& paths, std::span<const BodyId> spheres) const;

private:
    /// Moves spheres apart that overlap in resting contacts or those of `closed`, by the least that does it.
    void separate(System& system, const std::set<BodyPair>& closed) const;

    std::vector<std::vector<BodyId>> partners_;
    std::map<BodyPair, double>
        forces_;  ///< a < b; of the last substep, from which the next ones are found [mass length/time^2]
};

/// Speed of a rebound that rises no higher than the rounding of the place, with an acceleration g towards the partner;
/// below it bounces cannot be told from rest [length/time].
double speed_of_rest(const Bodies& bodies, const Contact& contact, double g);

}  // namespace carom::stepping
