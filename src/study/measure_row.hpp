/// \file
/// A row measured in full: errors, audit, time.
#pragma once

#include "study/audit/auditor.hpp"
#include "study/compared_reference.hpp"
#include "study/row_plan.hpp"

#include <vector>

namespace carom::study {

/// Things that all rows of a comparison share. Everything outlives the rows.
struct RowMeasurer {
    const Scene& scene;
    const CompareOptions& options;
    const ComparedReference& compared;
    Auditor& auditor;
    Patience& patience;

    /// The row; none if it was interrupted before its errors were known.
    /// \param on_time asked with the time that the recorded run has reached [time]; false interrupts
    std::optional<CompareRow> measure(const RowPlan& plan, const std::function<bool(double)>& on_time) const;
};

/// CPU times of repeated runs, or that of the recorded one where they would take too long.
/// \param times empty if none was repeated [s]
void put_times(std::vector<double> times, double recorded_seconds, CompareRow& row);

}  // namespace carom::study
