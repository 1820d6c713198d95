/// \file
/// Closings that the event method takes for rest: slower than v_c, of bodies that are as good as in contact.
#pragma once

#include "study/audit/truth.hpp"

#include <carom/study.hpp>

namespace carom::study {

/// Rate of the gap of two bodies just before `time` in an event-driven run: negative when they close [length/time].
double gap_rate_before(const Scene& scene, const Truth& run, const Vec3& normal, BodyId a, BodyId b, double time);

/// Whether an event-driven run has the two, at `time`, closer than a bounce at v_c is high, and no faster relative to
/// each other along the normal than v_c: an impact between them that it does not have was absorbed. False beyond the
/// end of the run.
bool is_absorbed(const Scene& scene, const Truth& run, BodyId a, BodyId b, double time);

}  // namespace carom::study
