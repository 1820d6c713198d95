/// \file
/// Which spheres may come near a body within the steps of a case.
#pragma once

#include "study/audit/truth.hpp"

#include <span>
#include <vector>

namespace carom::study {

/// The core, the spheres whose swept bound within `span` from `time` on meets that of one of it, and those that may
/// meet such a neighbour, so that it moves as in the whole scene until it meets the core. A bound takes the speed and
/// what gravity adds; for the core also what an elastic impact may add. \return ascending
std::vector<BodyId> bodies_near(const Scene& scene, const Truth& truth, std::span<const BodyId> core, double time,
                                double span);

}  // namespace carom::study
