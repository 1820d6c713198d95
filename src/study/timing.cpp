#include "study/clock.hpp"
#include "study/row.hpp"
#include "study/tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace carom::study {

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::vector<double> time_runs(const RowTask& task, double first_seconds, const TimingOptions& options)
{
    if (first_seconds > options.budget) return {};
    const double wanted = resolved_by_clock / std::max(first_seconds, resolved_by_clock / most_runs_in_a_row);
    const int batch = static_cast<int>(std::ceil(std::min(std::max(wanted, 1.0), most_runs_in_a_row)));

    std::vector<double> times;
    double spent = 0;
    for (int k = 0; k < options.repeats; ++k) {
        const double expected = times.empty() ? first_seconds * batch : spent / static_cast<double>(times.size());
        if (k > 0 && spent + expected > options.budget) break;
        const double start = thread_cpu_seconds();
        for (int i = 0; i < batch; ++i) static_cast<void>(simulate(task.scene, task.method, task.run));
        const double seconds = thread_cpu_seconds() - start;
        spent += seconds;
        times.push_back(seconds / batch);
    }
    return times;
}

}  // namespace carom::study
