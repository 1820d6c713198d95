/// \file
/// Pieces of motion that are no closed form: steps of numeric clusters and windows of the guard.
#pragma once

#include "event_driven/state.hpp"

#include <map>
#include <vector>

namespace carom {

/// Bodies as they are at one moment, within a numeric step as the cluster has them: more exact than the parabola that
/// stands for the piece (see `advanced`), which bodies outside the cluster see. Each cluster is placed once.
class Moment {
public:
    Moment(const State& state, const EpochTime& now) : state_(state), now_(now) {}
    /// The body's flight as if it began now.
    Flight flight(BodyId body);

private:
    const std::vector<NumericBody>& bodies(const Piece& piece, const EpochTime& start);

    const State& state_;
    const EpochTime now_;
    std::map<const NumericCluster*, std::vector<NumericBody>> bodies_;
};

}  // namespace carom
