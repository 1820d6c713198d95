/// \file
/// The exact rest of a calm heap, or of the part of it that is calm.
#pragma once

#include "window/window_problem.hpp"

namespace carom {

struct LandingOptions {
    double speed = 0;        ///< [velocity] of the fastest that may come to rest
    double way = 0;          ///< [length] > 0: farthest that a body may go
    double most_energy = 0;  ///< [energy] >= 0 by which places may rise: the kinetic energy that rest takes
};

enum class LandingStatus {
    rests,
    unbalanced,  ///< too little of the heap is held by forces that balance
    too_far,     ///< the rest is farther away than `way`, or above the energy
    overlaps     ///< bodies would meet on the way
};

struct LandingOutcome {
    LandingStatus status = LandingStatus::unbalanced;
    /// By body: whether it rests. Others stay where they are, and nothing that rests leans on them.
    std::vector<char> rests;
    /// Straight displacements, one after the other, by body: each is a window, and nothing overlaps on the way.
    std::vector<std::vector<Vec3>> moves;
    std::vector<double> forces;  ///< [force] by contact, > 0 of those that carry, 0 of others
    double residual = 0;         ///< [acceleration] largest of a body that rests
    double largest_gap = 0;      ///< [length] of contacts that carry, in the end
    double lifted = 0;           ///< [energy] by which places rose, most often < 0
    int factorisations = 0;
};

/// Finds the place of rest next to bodies that hardly move: projections of far falls on the linear bounds of the gaps
/// (each a step towards the lowest place; where as many contacts carry as there are directions they converge as
/// Newton's method does), then Newton's method on the gaps of the contacts that carry. Forces are those of statics.
/// Bodies that are fast, would go too far, that nothing holds, or that lean on such, are left out. This project's.
/// \param problem contacts of all pairs nearer than `way`
LandingOutcome land(const WindowProblem& problem, const LandingOptions& options);

}  // namespace carom
