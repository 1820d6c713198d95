/// \file
/// More impacts of one body within one window than any number of separate contacts explains are a Zeno point that
/// nobody sums. (The bound B n / h of the design: B a body.)
#pragma once

#include "event_driven/state.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace carom {

class ImpactRate {
public:
    explicit ImpactRate(const State& state)
        : recent_(state.flights.size()),
          bound_(state.scene.guard.impacts),
          length_(state.scene.guard.window.value_or(state.rest.numeric_step))
    {
    }

    /// Count an event of `body`, each event for one of its bodies; true when it is time to ask whether there are too
    /// many of its component: beyond B, and when they have grown by a sixteenth since.
    bool add(const State& state, const EpochTime& now, BodyId body)
    {
        if (!(length_ > 0)) return false;
        Recent& recent = recent_[static_cast<std::size_t>(body)];
        const double window = number(state, now);
        if (window != all_.window) all_ = {window, 0, 0};
        ++all_.count;
        if (recent.window != window) recent = {window, 0, bound_ + 1};
        if (++recent.count < recent.next) return false;
        recent.next = recent.count + 1 + recent.count / 16;
        return true;
    }

    /// Components of so many bodies have not had too many, for all bodies together have not had more.
    std::size_t enough() const { return static_cast<std::size_t>(all_.count / bound_) + 1; }

    /// Do these bodies have more than B events a body within the window, all added? Then until its end each further one
    /// is one too many.
    bool accumulates(const State& state, const EpochTime& now, std::span<const BodyId> component)
    {
        const double window = number(state, now);
        double sum = 0;
        for (const BodyId body : component) {
            const Recent& recent = recent_[static_cast<std::size_t>(body)];
            if (recent.window == window) sum += recent.count;
        }
        const bool is = sum > static_cast<double>(bound_) * static_cast<double>(component.size());
        for (const BodyId body : component) {
            Recent& recent = recent_[static_cast<std::size_t>(body)];
            if (recent.window != window) continue;
            recent.next = recent.count + 1;
            // None of them has to ask again soon.
            if (!is) recent.next = std::max(bound_ + 1, recent.next + recent.count / 16);
        }
        return is;
    }

private:
    struct Recent {
        double window = -1;
        int count = 0, next = 0;
    };

    /// Of the window: they follow one another from the start.
    double number(const State& state, const EpochTime& now) const
    {
        return std::floor(state.frame.seconds(now) / length_);
    }

    std::vector<Recent> recent_;  ///< by body: events in the current window
    Recent all_;                  ///< of all bodies
    int bound_;                   ///< B
    double length_;               ///< of a window [time]
};

}  // namespace carom
