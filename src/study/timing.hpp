/// \file
/// The time that a run takes.
#pragma once

#include "study/tolerances.hpp"

#include <carom/simulate.hpp>

#include <functional>
#include <vector>

namespace carom::study {

struct TimedRun {
    const Scene& scene;
    const Method& method;
    RunOptions run;
    std::vector<double> sample_times;         ///< at which it shows its states, as when it is judged [time]
    std::function<bool(double)> on_progress;  ///< false stops
};

struct TimingOptions {
    int repeats = timing_repeats;   ///< at least
    double budget = timing_budget;  ///< for all repeats together [s]
};

/// CPU times of runs; empty if one alone would take longer than the budget. Repeats go on until the median's interval
/// is within `timing_spread`, or `most_timings` are made, or the budget is spent. Short runs are repeated back to back
/// within one timing until they fill what the clock resolves. If interrupted: those finished before.
std::vector<double> time_runs(const TimedRun& run, double first_seconds, const TimingOptions& options);

/// Median; of an even number the mean of the middle two. \pre not empty
double median(std::vector<double> values);

/// All [s]. The interval of the median is that of the sign test: it asks nothing of how times are distributed. Of fewer
/// than six it is the least and the greatest.
struct MedianTime {
    double median = 0, min = 0, max = 0;
    double low = 0, high = 0;  ///< with at least 95 %, from six times on
};
/// \pre not empty
MedianTime median_time(std::vector<double> times);

}  // namespace carom::study
