/// \file
/// The bodies of a heap at one moment, as problems of windows have them.
#pragma once

#include "heap/near_pairs.hpp"
#include "math/disjoint_sets.hpp"
#include "motion/moment.hpp"
#include "window/window_problem.hpp"

#include <functional>
#include <span>

namespace carom {

/// Length of a window in a heap that is hot [time].
double hot_length(const State& state);

/// The bodies of a list at this moment. \invariant all by number in the list
struct WindowBodies {
    std::shared_ptr<const NearPairs> list;
    std::vector<Flight> flights;     ///< as if they began now
    std::vector<WindowBody> bodies;  ///< places relative to one of them
    std::vector<double> moved;       ///< since the list was made [length]
    std::vector<char> still;         ///< fixed or at rest
    std::vector<WindowPlane> planes;
    double hot = 0;  ///< length of a hot window [time]

    /// Whether a pair may push in a hot window: then its bodies are connected.
    bool is_close(std::size_t pair) const;
};

/// \param stands_still whether a body is fixed or at rest
WindowBodies bodies_now(const State& state, Moment& moment, const std::shared_ptr<const NearPairs>& list,
                        const std::function<bool(BodyId)>& stands_still);

/// Bodies of a landing belong together also where they are apart on the way. (A body that has landed is no more in
/// it.)
void join(DisjointSets& sets, const WindowBodies& all, std::span<const BodyId> bodies);

struct BeginAndEnd {
    Vec3 before, after;  ///< velocities [length/time]
};
/// Kinetic energy and height that a body loses over a displacement [energy].
double energy_taken(const State& state, BodyId body, const BeginAndEnd& velocities, const Vec3& displacement);

}  // namespace carom
