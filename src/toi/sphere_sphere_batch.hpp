/// \file
/// Level 0 over arrays: a loop without branches that compilers vectorise, in the widest registers of the machine.
#pragma once

#include "toi/level_0.hpp"

#include <cstddef>

namespace carom {

inline constexpr std::size_t batch_block = 128;

/// Inputs of one block, and what level 0 says: code 0 none, 1 impact, 2 for another level.
struct BatchBlock {
    const double *rx, *ry, *rz, *vx, *vy, *vz, *s;
    double *t, *t_lo, *t_hi;  ///< 0 unless code is 1
    double* code;
};

/// The whole interval, or the lower end alone (t and t_hi may be null).
void solve_block(const BatchBlock& block, std::size_t count);
void solve_block_lower(const BatchBlock& block, std::size_t count);

}  // namespace carom
