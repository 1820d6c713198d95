/// \file
/// The peer as a server of runs: how `carom compare` and `carom tunnel` ask for their rows.
#pragma once

#include "peer.hpp"

namespace carom::peers {

/// Answers requests on stdin until it ends; docs/peers.md has the format. A request is two lines,
///
///     run DT T1 T2 ...
///     {"format": "carom-scene/1", ...}
///
/// and its answer on stdout a trace with velocities, the frames being those times:
///
///     # ODE, double precision, tuned: ...
///     t,id,x,y,z,vx,vy,vz
///     ...
///     # steps 240 cpu_seconds 0.0012
///     # end
///
/// or `# error WHAT` in place of all that comes before `# end`.
void serve(Settings settings);

}  // namespace carom::peers
