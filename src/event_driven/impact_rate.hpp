/// \file
/// More impacts of one body within one window than any number of separate contacts explains are a Zeno point that
/// nobody sums. (The bound B n / h of the design: B a body.)
#pragma once

#include "event_driven/state.hpp"

namespace carom {

class ImpactRate {
public:
    explicit ImpactRate(const State& state)
        : recent_(state.flights.size()),
          bound_(state.scene.guard.impacts),
          window_(state.scene.guard.window.value_or(state.rest.numeric_step))
    {
    }

    /// Count an event of `body`; true if it is one too many. It then begins anew.
    bool accumulates(const State& state, const EpochTime& now, BodyId body)
    {
        Recent& recent = recent_[static_cast<std::size_t>(body)];
        if (recent.count == 0 || state.frame.between(recent.since, now) > window_) recent = {now, 0};
        if (++recent.count <= bound_) return false;
        recent.count = 0;
        return true;
    }

private:
    struct Recent {
        EpochTime since;
        int count = 0;
    };
    std::vector<Recent> recent_;  ///< by body: events in the current window
    int bound_;                   ///< B
    double window_;               ///< [time]
};

}  // namespace carom
