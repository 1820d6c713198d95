/// \file
/// More impacts of one body within one window than any number of separate contacts explains are a Zeno point that
/// nobody sums. (The bound B n / h of the design: B a body.)
#pragma once

#include "event_driven/state.hpp"

#include <span>

namespace carom {

class ImpactRate {
public:
    explicit ImpactRate(const State& state)
        : recent_(state.flights.size()),
          bound_(state.scene.guard.impacts),
          window_(state.scene.guard.window.value_or(state.rest.numeric_step))
    {
    }

    /// Count an event of `body`; true when it is time to ask whether there are too many of its component: after each B.
    bool add(const State& state, const EpochTime& now, BodyId body)
    {
        Recent& recent = recent_[static_cast<std::size_t>(body)];
        if (recent.count == 0 || state.frame.between(recent.since, now) > window_) recent = {now, 0};
        return ++recent.count % (bound_ + 1) == 0;
    }

    /// Do these bodies have more than B events each within the window, on average? Then all begin anew.
    bool accumulates(const State& state, const EpochTime& now, std::span<const BodyId> component)
    {
        double sum = 0;
        for (const BodyId body : component) {
            const Recent& recent = recent_[static_cast<std::size_t>(body)];
            if (recent.count > 0 && !(state.frame.between(recent.since, now) > window_)) sum += recent.count;
        }
        if (!(sum > static_cast<double>(bound_) * static_cast<double>(component.size()))) return false;
        for (const BodyId body : component) recent_[static_cast<std::size_t>(body)].count = 0;
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
