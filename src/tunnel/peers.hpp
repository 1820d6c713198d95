/// \file
/// Collision libraries of others that throws are put to. Their adapters are in tools/peers, which only the command line
/// tool links; where a library was not found at build time its contestants are absent, with the reason.
#pragma once

#include "tunnel/study.hpp"

namespace carom::tunnel {

struct Peers {
    std::vector<std::string> names;       ///< of methods, whether they are there or not
    std::vector<Contestant> contestants;  ///< one for each name and variant, or none
    std::string absent;                   ///< why there are none; empty if there are
};

/// `fcl_naive`, `fcl_advancement`: fcl::continuousCollide with the solvers and motions that work.
Peers fcl_peers();
/// `libccd_advancement`: conservative advancement by libccd's MPR.
Peers libccd_peers();

}  // namespace carom::tunnel
