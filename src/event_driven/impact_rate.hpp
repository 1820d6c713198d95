/// \file
/// The rate of impacts. More of them within one window than separate contacts explain are a Zeno point that nothing
/// sums. The bound is B n for n connected bodies, more for those that are no heap; windows follow one another
/// (docs/impacts.md, section 7).
#pragma once

#include "gather/heap.hpp"
#include "motion/state.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace carom {

class ImpactRate {
public:
    explicit ImpactRate(const State& state)
        : recent_(state.scene.spheres.size()),
          bound_(state.scene.guard.impacts),
          heap_bound_(has_windows(state) ? std::min(bound_, hot_impacts) : bound_),
          group_bound_(static_cast<double>(bound_) * std::max(1.0, bounces_in_window / loss_of_longest(state))),
          length_(state.scene.guard.window.value_or(state.rest.numeric_step))
    {
    }

    /// Counts an event of `body`, each event for one of its bodies. \returns whether its component may have had too
    /// many, so that it is time to ask: beyond B, then when it has used up its share of what the last answer left.
    bool add(const State& state, const EpochTime& now, BodyId body)
    {
        Recent& recent = recent_[static_cast<std::size_t>(body)];
        const double window = number(state, now);
        if (window != all_.window) all_ = {window, 0, 0};
        ++all_.count;
        if (recent.window != window) recent = {window, 0, heap_bound_ + 1};
        return ++recent.count >= recent.next;
    }

    /// Number of bodies from which on a component cannot have had too many, for all bodies together have not had more;
    /// of a heap at least.
    std::size_t enough() const
    {
        return std::max(largest_group, static_cast<std::size_t>(all_.count / heap_bound_)) + 1;
    }

    /// Whether these bodies together have had more than B events a body within the window. From then until its end each
    /// further event is one too many. \pre add has just asked for one of them
    bool accumulates(const State& state, const EpochTime& now, std::span<const BodyId> component)
    {
        const double window = number(state, now);
        std::int64_t sum = 0;
        for (const BodyId body : component) {
            const Recent& recent = recent_[static_cast<std::size_t>(body)];
            if (recent.window == window) sum += recent.count;
        }
        const double bound = component.size() > largest_group ? static_cast<double>(heap_bound_) : group_bound_;
        const double left =
            bound - static_cast<double>(sum) / static_cast<double>(component.size());  // for each of them
        for (const BodyId body : component) {
            Recent& recent = recent_[static_cast<std::size_t>(body)];
            if (recent.window != window) recent = {window, 0, 0};
            recent.next = recent.count + 1 + std::max<std::int64_t>(0, static_cast<std::int64_t>(left));
        }
        return left < 0;
    }

private:
    struct Recent {
        std::optional<double> window{};
        std::int64_t count = 0, next = 0;
    };

    /// 1 - e of those bounces which take longest, of all that are carried out until rounding ends them.
    static double loss_of_longest(const State& state)
    {
        return 1 - state.laws.restitution_up_to(1 - bounces_of_rounding / most_bounces);
    }

    /// Number of the window: windows follow one another from the start.
    double number(const State& state, const EpochTime& now) const
    {
        return std::floor(state.frame.seconds(now) / length_);
    }

    std::vector<Recent> recent_;  ///< by body: events in the current window
    Recent all_;                  ///< of all bodies
    std::int64_t bound_;          ///< B
    std::int64_t heap_bound_;     ///< B of heaps
    double group_bound_;          ///< B of bodies that are in no heap
    double length_;               ///< of a window [time]
};

}  // namespace carom
