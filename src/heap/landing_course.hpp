/// \file
/// The way of a part of a heap to exact rest, in moves that are windows each.
#pragma once

#include "motion/window_piece.hpp"
#include "window/landing.hpp"

namespace carom {

/// The course of the bodies of a problem that can come to rest, null where there is none near.
/// \param ids of the problem's bodies
std::shared_ptr<const LandingCourse> find_course(const WindowProblem& problem, const std::vector<BodyId>& ids,
                                                 const LandingOptions& options);

}  // namespace carom
