/// \file
/// One row of a comparison: a recorded run against the reference.
#pragma once

#include "reference/reference.hpp"
#include "study/audit/truth.hpp"
#include "study/sample_times.hpp"

#include <carom/study.hpp>

#include <functional>

namespace carom::study {

struct RowTask {
    const Scene& scene;
    const Reference& reference;
    Method method;
    RunOptions run;
    const SampleTimes& times;                 ///< the reference's samples are the first of its moments
    const Truth& truth;                       ///< an event-driven run
    std::function<bool(double)> on_progress;  ///< of the recorded run
};

struct RecordedRow {
    CompareRow row;  ///< errors and counts; empty if interrupted
    double cpu_seconds = 0;
    bool interrupted = false;
};
RecordedRow record_row(const RowTask& task);

/// Distance from the reference beyond which a run has diverged, 0.01 r_min [length].
double divergence_threshold(const Scene& scene);

}  // namespace carom::study
