/// \file
/// Changes of flights that no contact makes, or that frames cannot tell from those of a method's steps.
#pragma once

#include "audit/around.hpp"

namespace carom::audit {

/// Whether the place at the end of the interval is unknown to more than a hundredth of the radius. \pre it has a flight
bool is_coarse(const Scene& scene, const Interval& interval, std::size_t sphere);

/// Whether frames cannot tell the change from the end of a step of a method that moves straight within its steps: it
/// goes along the pull, and the frames are too close, or too short of digits, to show that flights bend.
bool may_end_a_step(const BodyMotion& motion);

/// Whether the one plane that can have touched a sphere would have had to pull it: a contact pushes.
bool is_pulled_back(const Scene& scene, const Interval& interval, std::size_t sphere, const Around& around);

/// Whether a sphere goes on alike from another place, and at most one body can have had a part in it: between two it
/// may have gone to and fro.
bool has_jumped(const Scene& scene, const Interval& interval, std::size_t sphere, const Around& around);

}  // namespace carom::audit
