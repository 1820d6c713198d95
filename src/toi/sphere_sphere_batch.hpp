/// \file
/// Level 0 over arrays: a loop without branches that compilers vectorise, in the widest registers of the machine.
#pragma once

#include "toi/level_0.hpp"
#include "toi/tolerances.hpp"

#include <carom/time_of_impact.hpp>

#include <cstddef>

namespace carom {

/// Inputs of one block, and what level 0 says; the status is `touching` where it is for another level to say.
struct BatchBlock {
    const double *rx, *ry, *rz, *vx, *vy, *vz, *s;
    double *t, *t_lo, *t_hi;  ///< 0 unless there is certainly an impact
    ImpactStatus* status;
};

/// The whole interval, or the lower end alone (t and t_hi may be null). Is anything left to another level?
/// \pre count <= batch_block
bool solve_block(const BatchBlock& block, std::size_t count);
bool solve_block_lower(const BatchBlock& block, std::size_t count);

}  // namespace carom
