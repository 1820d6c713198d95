/// \file
/// A window of a heap: what its bodies share while they go straight on, and what the next window takes from it
/// (docs/windows.md).
#pragma once

#include "core/partner.hpp"
#include "flight/flight.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace carom {

/// Two bodies that may meet, or a body and a plane. Spheres have their number in the list, not that of the scene.
struct NearPair {
    int a = 0;  ///< it can move
    Partner b;
};

/// A list of pairs that lasts while no body goes farther than half of the skin.
struct NearPairs {
    std::vector<BodyId> bodies;  ///< ascending; fixed and resting ones that others are near, too
    std::vector<Place> places;   ///< by body: where it was as the list was made
    std::vector<char> still;  ///< by body: it was fixed or at rest, so that only pairs with bodies that move are listed
    std::vector<NearPair> pairs;  ///< ascending, each once; of two that can move a is the smaller
    double skin = 0;              ///< largest gap of a pair [length]
    double smallest = 0;          ///< radius of those that can move [length]
};

struct ContactForce {
    BodyId a = no_body;
    Partner b;
    double force = 0;  ///< mean over the window, >= 0 [mass length/time^2]
};

/// Force on a body at rest [mass length/time^2].
struct Load {
    BodyId body = no_body;
    Vec3 force = Vec3::Zero();
};

/// The last way of a heap to exact rest, move by move.
struct LandingCourse {
    std::vector<BodyId> bodies;            ///< that come to rest, ascending
    std::vector<Vec3> velocities;          ///< by body, as it began [length/time]
    std::vector<std::vector<Vec3>> moves;  ///< by move and body [length]
    std::vector<double> left;              ///< by move: part of the velocities that is left after it [1]
    std::vector<ContactForce> forces;      ///< of contacts that carry, ascending
    std::vector<Load> loads;               ///< on other bodies, fixed or at rest, in the end
};
struct LandingStage {
    std::shared_ptr<const LandingCourse> course;
    std::size_t move = 0;
};

/// Patience between attempts to land.
struct LandingWait {
    double hot_windows = 0;    ///< time to wait [hot windows]
    double after_waking = 0;   ///< time that was waited after the last waking [hot windows]
    double after_failure = 0;  ///< time that was waited after the last attempt, if it failed [hot windows]
    double failed_speed = 0;   ///< root mean square at the last attempt that failed [length/time]
};

class RestingPart;

struct WindowPiece {
    std::vector<BodyId> bodies;    ///< ascending
    std::vector<Vec3> velocities;  ///< by body, before the window [length/time]
    double length = 0;             ///< [time]
    EpochTime end;                 ///< that it had as it began
    double hot_fastest = 0;        ///< fastest body in it [length/time]
    double taken = 0;              ///< energy that the books have for it, if it is not interrupted [energy]
    std::shared_ptr<const NearPairs> near;
    std::vector<ContactForce> forces;  ///< that the solver ended with, ascending
    LandingWait wait;
    std::optional<LandingStage> landing;
    std::vector<Load> loads;                                   ///< that it puts on bodies at rest, in their forces
    std::vector<std::shared_ptr<const RestingPart>> carriers;  ///< their parts
};

}  // namespace carom
