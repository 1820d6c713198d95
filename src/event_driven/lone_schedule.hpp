/// \file
/// Prediction for one sphere among planes: no queue, no broad phase, no stamps.
#pragma once

#include "event_driven/predict_planes.hpp"

#include <span>

namespace carom {

class LoneSchedule {
public:
    struct Next {
        Key key;
    };

    LoneSchedule(const State& state, BroadPhase, Counts& counts)
    {
        if (state.count() > 0) flight_changed(state, 0, {}, counts);
    }

    const Next& next() const { return next_; }
    void flight_changed(const State& state, BodyId body, const EpochTime&, Counts& counts)
    {
        next_.key = first_of_planes<true>(state, moving(state, body), counts);
    }

    // What a single sphere has no use for.
    bool is_stale(const State&, const Next&) const { return false; }
    void predict_again(const State&, const Next&, Counts&) {}
    void cross(const State&, const Key&, Counts&) {}
    std::span<const BodyId> neighbours(BodyId) const { return {}; }

private:
    Next next_;
};

}  // namespace carom
