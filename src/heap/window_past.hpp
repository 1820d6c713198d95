/// \file
/// Knowledge that a part of a heap has of the windows before: forces, heat, patience, a landing that goes on.
#pragma once

#include "heap/window_part.hpp"

#include <span>

namespace carom {

/// Forces by contact of the last windows, and of bodies that are woken: where solving begins.
/// \param ids by number in the problem
std::vector<double> forces_before(const State& state, const WindowProblem& problem, std::span<const BodyId> ids,
                                  const WindowHistory& history);

/// Speeds of a part. Bodies that lean on planes alone may glide for ever: the others are held, or nearly.
struct Heat {
    double fastest = 0;       ///< [length/time]
    double fastest_held = 0;  ///< of bodies that others hold
    double rms_held = 0;      ///< likewise, by mass
};
/// \param count of bodies of the part, the first of the problem \param forces by contact
Heat heat_of(const WindowProblem& problem, std::span<const double> forces, std::size_t count);

/// Legacy of the window before.
struct WindowPast {
    bool exists = false;
    LandingWait wait;
    std::optional<LandingStage> course;  ///< a landing that goes on, and its next move
};
/// \param bodies of the part
WindowPast past_of(std::span<const BodyId> bodies, const WindowHistory& history);

}  // namespace carom
