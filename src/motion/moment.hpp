/// \file
/// Bodies at one moment, those in the midst of a piece that is no closed form included: steps of numeric clusters and
/// windows of the guard.
#pragma once

#include "motion/numeric_cluster.hpp"
#include "motion/state.hpp"

#include <map>
#include <vector>

namespace carom {

/// One step of a numeric cluster, shared by the motions of its bodies.
struct NumericPiece {
    NumericCluster cluster;  ///< as the step began
    NumericStep step;
    Place centre{};  ///< to which the cluster's positions are relative
};

/// Within a numeric step bodies are as the cluster has them: more exact than the parabola that stands for the piece
/// (see `advanced`), which bodies outside the cluster see. Each cluster is placed once.
class Moment {
public:
    Moment(const State& state, const EpochTime& now) : state_(state), now_(now) {}
    /// The body's flight as if it began now.
    Flight flight(BodyId body);

private:
    const std::vector<NumericBody>& bodies(const Stepping& stepping, const EpochTime& start);

    const State& state_;
    const EpochTime now_;
    std::map<const NumericPiece*, std::vector<NumericBody>> bodies_;
};

/// One body within its numeric step, before anything is put back; others as they fly.
Flight flight_within_step(const State& state, BodyId body, const EpochTime& now);

}  // namespace carom
