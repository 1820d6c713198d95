/// \file
/// One row of a comparison: a recorded run against the reference, then the time it takes unrecorded.
#pragma once

#include "reference/reference.hpp"
#include "study/tolerances.hpp"

#include <carom/study.hpp>

#include <functional>

namespace carom::study {

struct RowTask {
    const Scene& scene;
    const Reference& reference;
    Method method;
    RunOptions run;
    std::vector<double> sample_times;         ///< the reference's are the first of them [time]
    std::function<bool(double)> on_progress;  ///< of the recorded run
};

struct RecordedRow {
    CompareRow row;  ///< everything but the times
    double cpu_seconds = 0;
    bool interrupted = false;
};
RecordedRow record_row(const RowTask& task);

struct TimingOptions {
    int repeats = timing_repeats;
    double budget = timing_budget;  ///< for all repeats together [s]
};

/// CPU times of unrecorded runs; empty if one alone would take longer than the budget. Short runs are repeated back to
/// back within one timing until they fill what the clock resolves.
std::vector<double> time_runs(const RowTask& task, double first_seconds, const TimingOptions& options);

/// Median; of an even number the mean of the middle two. \pre not empty
double median(std::vector<double> values);

/// 0.01 r_min: farther from the reference than this, a run has diverged (CONTRACT section 4) [length].
double divergence_threshold(const Scene& scene);

}  // namespace carom::study
