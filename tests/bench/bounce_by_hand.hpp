/// \file
/// What somebody would write who needs one ball on one plane and nothing else: the yardsticks of the kernel
/// for a single sphere.
#pragma once

#include <carom/event.hpp>
#include <carom/scene.hpp>

#include <cstdint>
#include <functional>

namespace bounce_by_hand {

struct Log {
    std::int64_t impacts = 0;
    double max_penetration = 0, plane_impulse = 0;
    std::uint64_t hash = 0;  ///< as carom's `event_hash`; 0 where the arithmetic is not the engine's
};

/// With the promises of the engine kept, from its own bricks (root, law, frame, hash): times and places that do not
/// lose digits as the run goes on, height by a compensated sum, rest by arithmetic; impulse, penetration and hash of
/// each impact. The same bits as the engine's. What it has not: more than one plane, series, plates, samples, limits.
Log same_bits(const carom::Scene& scene, const std::function<void(const carom::Event&)>& on_event);

/// High school physics on a horizontal floor at 0, without any of these: no log, and a clock that loses digits.
Log plain(const carom::Scene& scene);

}  // namespace bounce_by_hand
