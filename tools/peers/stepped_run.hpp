/// \file
/// An engine's run with its states at given times.
#pragma once

#include "peer.hpp"

#include <carom/simulate.hpp>

#include <vector>

namespace carom::peers {

struct SteppedRun {
    std::vector<std::vector<BodyState>> samples;  ///< one for each time
    double cpu_seconds = 0;                       ///< of the steps alone [s]
    long long steps = 0;
};

/// States of all spheres as the engine has them now.
std::vector<BodyState> states_of(const Engine& engine, std::size_t spheres);

/// Between the ends of a step states are those of the engine's own motion, which is straight at the velocity that the
/// step ends with: both engines change velocities first and move then. The velocity within a step goes from that before
/// it to that after it if gravity alone made the difference, else it is that after it.
/// \param times ascending, >= 0 [time]
SteppedRun stepped_run(const Scene& scene, const Settings& settings, Engine& engine, const std::vector<double>& times);

}  // namespace carom::peers
