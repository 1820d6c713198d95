/// \file
/// The impacts of a recorded run beside those of the reference.
#pragma once

#include "study/matching.hpp"
#include "study/row.hpp"

#include <vector>

namespace carom::study {

/// Collects the impacts of one row's run. The task must outlive it.
class RowImpacts {
public:
    explicit RowImpacts(const RowTask& task);

    /// \param horizon until which somebody will ask [time]
    void add(const Event& event, double horizon);
    /// A series that is still going on at the end of the run stands for its bounces as a finished one does.
    void end_open_series(const Outcome& outcome);
    /// Impacts found, missed and invented up to the horizon; for the event method also its audit.
    void put_into(CompareRow& row, double horizon) const;

private:
    bool is_event() const { return step_options(task_.method) == nullptr; }
    /// Slower than v_c, which the event method alone has.
    bool is_slow(const Event& event) const;

    const RowTask& task_;
    double width_;  ///< how far apart the times of one impact may be in two runs [time]
    double v_c_;    ///< [length/time]
    std::vector<FoundImpact> found_, rests_;
};

}  // namespace carom::study
