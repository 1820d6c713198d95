/// \file
/// The plan of a search for a step: which one to try next, after what is known of those tried.
#pragma once

#include <carom/study.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace carom::study {

/// Steps are tried on a grid of 128 in each factor of two. First by factors of 4, down until one holds or up until one
/// does not; then from a quarter of the largest that holds below all that fail up to the smallest of these, one in each
/// factor of two, two, four, up to 32; then all of the grid in the upper part of that range, where steps that fail are
/// likely. Where a step fails the range moves down, and what it lacks there is tried first.
class StepScan {
public:
    /// \param first the step to begin with [time] \param largest the largest that is tried, >= first [time]
    StepScan(double first, double largest);

    void add(const StepSearch::Try& tried);

    /// The next step to try; none where all are known.
    std::optional<double> next() const;
    /// The largest step that holds below all that do not; none if there is none.
    std::optional<double> enough() const;
    /// Steps in ascending order.
    const std::vector<StepSearch::Try>& tries() const { return tries_; }

private:
    double step(int index) const;
    /// The largest index whose step is not above `dt`.
    int index_below(double dt) const;
    bool is_tried(double dt) const;
    /// The largest step not tried from `from` up to the first that fails, every `apart`th of the grid.
    std::optional<double> gap(double from, int apart) const;
    /// The smallest step that fails; infinite if none does [time].
    double fails() const;

    double first_, largest_;
    int top_;  ///< index of the largest step
    std::vector<StepSearch::Try> tries_;
};

/// Figures of a search that are told.
struct SearchFigures {
    std::size_t held = 0;                    ///< tries at or below the step found: all hold
    double worst_error = 0;                  ///< of these [length]
    std::optional<StepSearch::Try> too_far;  ///< the smallest step above it that was tried
    std::optional<StepSearch::Try> best;     ///< the smallest error of all
    std::size_t lucky = 0;                   ///< tries that hold although a smaller step does not
    std::optional<StepSearch::Try> fails;    ///< the smallest step that does not hold
};
SearchFigures figures_of(const StepSearch& search);

}  // namespace carom::study
