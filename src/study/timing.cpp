#include "study/timing.hpp"

#include "study/clock.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::study {

namespace {

/// Ranks, from below and from above, of the values that bound the median with 95 %: the largest k for which fewer than
/// k of n lie below it with at most 2.5 %, by the binomial distribution of one half.
std::size_t rank_of_bound(std::size_t n)
{
    double term = std::ldexp(1.0, -static_cast<int>(n)), below = term;
    std::size_t k = 0;
    while (below <= one_sided_95 && k + 1 < n) {
        ++k;
        term *= static_cast<double>(n - k + 1) / static_cast<double>(k);
        below += term;
    }
    return k == 0 ? 0 : k - 1;
}

}  // namespace

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

MedianTime median_time(std::vector<double> times)
{
    std::sort(times.begin(), times.end());
    const std::size_t k = times.size() < fewest_for_interval ? 0 : rank_of_bound(times.size());
    return {median(times), times.front(), times.back(), times[k], times[times.size() - 1 - k]};
}

std::vector<double> time_runs(const TimedRun& run, double first_seconds, const TimingOptions& options)
{
    if (first_seconds > options.budget) return {};
    const double wanted = resolved_by_clock / std::max(first_seconds, resolved_by_clock / most_runs_in_a_row);
    const int batch = static_cast<int>(std::ceil(std::min(std::max(wanted, 1.0), most_runs_in_a_row)));

    // Each method gives the samples that it is judged by, and pays for them.
    double shown = 0;
    Observer observer;
    observer.sample_times = run.sample_times;
    observer.on_sample = [&](std::size_t, double, std::span<const BodyState> states) {
        if (!states.empty()) shown += states.front().position.x();
    };
    observer.on_progress = run.on_progress;
    std::vector<double> times;
    double spent = 0;
    const int most = std::max(options.repeats, most_timings);
    for (int k = 0; k < most; ++k) {
        if (k >= options.repeats) {
            const MedianTime now = median_time(times);
            if (now.high - now.low <= timing_spread * now.median) break;
        }
        const double expected = times.empty() ? first_seconds * batch : spent / static_cast<double>(times.size());
        if (k > 0 && spent + expected > options.budget) break;
        const double start = thread_cpu_seconds();
        for (int i = 0; i < batch; ++i)
            if (simulate(run.scene, run.method, run.run, observer).status == Status::interrupted) return times;
        const double seconds = thread_cpu_seconds() - start;
        spent += seconds;
        times.push_back(seconds / batch);
    }
    return times;
}

}  // namespace carom::study
