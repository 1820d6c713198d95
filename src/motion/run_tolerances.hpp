/// \file
/// The tolerances of a run: what is as good as nothing in it, computed once from its thresholds of rest.
#pragma once

#include "contact/tolerances.hpp"
#include "math/length.hpp"
#include "motion/tolerances.hpp"
#include "scene/tolerances.hpp"

#include <carom/scene.hpp>

#include <algorithm>

namespace carom {

struct Tolerances {
    double gap = 0;           ///< of contacts that persist, see `closed` [length]
    double speed = 0;         ///< of contacts that neither open nor close, see `slow` [length/time]
    double acceleration = 0;  ///< that opens no contact [length/time^2]
    double impulse = 0;       ///< change of speed that is none [largest speed]
    double tie = 0;           ///< gap at which a contact belongs to the instant of another [smaller radius]

    /// Speed that is as good as none where contacts persist [length/time]. \param fastest speed of the bodies concerned
    double slow(double fastest) const { return std::max(speed, closing_tolerance * fastest); }
    /// Gap at which a contact may persist [length]. \param radius the smaller one
    double closed(double radius) const { return std::max(gap, declared_contact * radius); }
};

inline Tolerances make_tolerances(const Scene& scene, const RestThresholds& rest)
{
    return {rest.gap_tolerance, slow_part * rest.closing_speed, soft_part * length(scene.gravity), projection_tolerance,
            scene.impact.tie.value_or(default_tie)};
}

}  // namespace carom
