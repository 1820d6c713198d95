/// \file
/// One window of a heap: straight motions that keep every linear bound of a gap, and so overlap at no time.
#pragma once

#include "window/window_problem.hpp"

namespace carom {

/// The motion of all bodies in one window. With w = v + h a the velocities u are the projection of w, in the metric of
/// kinetic energy, on gap + h n.(u_a - u_b) >= 0 for all contacts. A gap is a convex function of the relative place, so
/// that along straight lines it stays above its linear bound: whatever satisfies the bounds at the window's end
/// overlaps at no time. Bodies that nothing pushes keep their parabola where the bounds allow it. After the scheme of
/// Maury, A time-stepping scheme for inelastic collisions, Numerische Mathematik 102 (2006),
/// https://doi.org/10.1007/s00211-005-0666-6, known from its abstract; energy, early ends and restitution are this
/// project's (docs/windows.md).
///
/// Guaranteed, whatever the solver leaves: gaps are above -`overlap_of_rounding` radii at every time (or above those of
/// the start), impulses >= 0, momentum to rounding, and energy does not grow beyond `energy_of_rounding`. What cannot
/// be had in the window's length is had in a shorter one; what cannot be had at all is `infeasible`.
WindowOutcome take_window(const WindowProblem& problem, const WindowOptions& options);

}  // namespace carom
