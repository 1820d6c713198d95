/// \file
/// The audit of a trace: places of bodies in frames, of whatever engine, against contacts as they must be.
///
/// Each interval between two frames is judged by itself: the flight of a body is the parabola through three frames
/// before it, its change is seen against the one through three frames behind it, and whether two bodies touch is
/// answered by the exact time of impact of their flights. Nothing of an earlier error is carried on.
#pragma once

#include "audit/report.hpp"
#include "audit/trace.hpp"

#include <carom/scene.hpp>

namespace carom::audit {

/// \pre the scene is valid; the trace has two frames at least. Memory does not grow with their number.
TraceAudit audit_trace(const Scene& scene, FrameSource& trace, const OnProgress& on_progress = {});

}  // namespace carom::audit
