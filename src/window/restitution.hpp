/// \file
/// Rebounds at the end of a window, for contacts that closed fast as it began.
#pragma once

#include "window/relaxation.hpp"

namespace carom {

struct Rebound {
    int row = 0;         ///< a contact that pushed in the window
    double rate = 0;     ///< [velocity] wanted: e times the closing speed, 0 of a contact that closed slowly
    double impulse = 0;  ///< [impulse] >= 0, the result
    bool fast = false;
};

struct ReboundProblem {
    std::vector<Vec3> velocities;  ///< after the window, by body and one that is fixed
    std::vector<double> inverse_masses;
    double most_energy = 0;      ///< [energy] >= 0 that rebounds may give back
    double speed_tolerance = 0;  ///< [velocity]
};

/// Impulses of pairs, from the bodies of fast contacts outwards, all scaled by one factor so that they give back no
/// more than `most_energy`. This project's.
/// \param velocities in `problem` are changed to those after the rebounds
/// \returns the energy that was given back [energy], negative where rebounds took more
double rebound(const std::vector<RelaxationRow>& rows, std::vector<Rebound>& rebounds, ReboundProblem& problem);

}  // namespace carom
