#include "study/measure_row.hpp"

#include "study/row.hpp"
#include "study/timing.hpp"

namespace carom::study {

void put_times(std::vector<double> times, double recorded_seconds, CompareRow& row)
{
    row.repeats = static_cast<int>(times.size());
    if (times.empty()) times.push_back(recorded_seconds);
    const MedianTime time = median_time(times);
    row.cpu_seconds = time.median;
    row.cpu_min = time.min;
    row.cpu_max = time.max;
    row.cpu_low = time.low;
    row.cpu_high = time.high;
}

namespace {

/// An event run that stops beyond what is compared says so all the same.
void tell_how_it_ends(const Truth& whole, double until, CompareRow& row)
{
    if (row.status != Status::reached_end || whole.status == Status::reached_end || whole.until >= until) return;
    row.status = whole.status;
    row.message = whole.message;
    row.time = whole.until;
}

}  // namespace

std::optional<CompareRow> RowMeasurer::measure(const RowPlan& plan, const std::function<bool(double)>& on_time) const
{
    const bool is_event = step_options(plan.method) == nullptr;
    // Another operator than the scene's is a scene, and a run, of its own.
    const bool is_own = plan.impact && *plan.impact != scene.impact.impact_operator;
    std::optional<Scene> other;
    std::optional<Truth> other_truth;
    if (is_own) {
        other = scene;
        other->impact.impact_operator = *plan.impact;
        other_truth = record_truth(*other, options.until, [&](const Progress&) { return patience.lasts(); });
    }
    const Scene& run_scene = is_own ? *other : scene;
    const Truth& truth = is_own ? *other_truth : auditor.truth();
    const RunOptions run{.until = compared.until};
    RecordedRow recorded =
        record_row({run_scene, compared.reference, plan.method, run, compared.times, truth, on_time});
    if (recorded.interrupted) return std::nullopt;
    CompareRow& row = recorded.row;
    describe(plan, row);
    if (is_event)
        tell_how_it_ends(truth, options.until, row);
    else
        row.audit = auditor.audit(plan.method, patience);
    const TimedRun timed{run_scene, plan.method, run, compared.times.asked, [&](double) { return patience.lasts(); }};
    put_times(time_runs(timed, recorded.cpu_seconds, {options.repeats, options.repeat_seconds}), recorded.cpu_seconds,
              row);
    return row;
}

}  // namespace carom::study
