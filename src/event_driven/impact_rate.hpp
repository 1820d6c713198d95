/// \file
/// More impacts of one body within one window than any number of separate contacts explains are a Zeno point that
/// nobody sums. (The bound of the design, B n / h of a component of n bodies; windows of h follow one another.)
#pragma once

#include "motion/state.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace carom {

class ImpactRate {
public:
    explicit ImpactRate(const State& state)
        : recent_(state.scene.spheres.size()),
          bound_(state.scene.guard.impacts),
          length_(state.scene.guard.window.value_or(state.rest.numeric_step))
    {
    }

    /// Count an event of `body`, each event for one of its bodies; true when its component may have had too many, and
    /// it is time to ask: beyond B, then when it has used up its share of what the last answer left.
    bool add(const State& state, const EpochTime& now, BodyId body)
    {
        Recent& recent = recent_[static_cast<std::size_t>(body)];
        const double window = number(state, now);
        if (window != all_.window) all_ = {window, 0, 0};
        ++all_.count;
        if (recent.window != window) recent = {window, 0, bound_ + 1};
        return ++recent.count >= recent.next;
    }

    /// Components of so many bodies have not had too many, for all bodies together have not had more.
    std::size_t enough() const { return static_cast<std::size_t>(all_.count / bound_) + 1; }

    /// Do these bodies have more than B events a body within the window, all added? Then until its end each further one
    /// is one too many. \pre add has just asked for one of them
    bool accumulates(const State& state, const EpochTime& now, std::span<const BodyId> component)
    {
        const double window = number(state, now);
        std::int64_t sum = 0;
        for (const BodyId body : component) {
            const Recent& recent = recent_[static_cast<std::size_t>(body)];
            if (recent.window == window) sum += recent.count;
        }
        const double left = static_cast<double>(bound_) -
                            static_cast<double>(sum) / static_cast<double>(component.size());  // for each of them
        for (const BodyId body : component) {
            Recent& recent = recent_[static_cast<std::size_t>(body)];
            if (recent.window != window) recent = {window, 0, 0};
            recent.next = recent.count + 1 + std::max<std::int64_t>(0, static_cast<std::int64_t>(left));
        }
        return left < 0;
    }

private:
    struct Recent {
        double window = -1;
        std::int64_t count = 0, next = 0;
    };

    /// Of the window: they follow one another from the start.
    double number(const State& state, const EpochTime& now) const
    {
        return std::floor(state.frame.seconds(now) / length_);
    }

    std::vector<Recent> recent_;  ///< by body: events in the current window
    Recent all_;                  ///< of all bodies
    std::int64_t bound_;          ///< B
    double length_;               ///< of a window [time]
};

}  // namespace carom
