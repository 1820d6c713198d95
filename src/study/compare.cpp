#include "core/expect.hpp"
#include "reference/reference.hpp"
#include "study/clock.hpp"
#include "study/row.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <carom/study.hpp>

#include <algorithm>
#include <cmath>

namespace carom {

namespace {

/// Every method with every step, in the order asked for.
std::vector<Method> methods_to_run(const CompareOptions& options)
{
    std::vector<Method> methods;
    for (const std::string& wanted : options.methods) {
        const Method first = make_method(wanted, options.step);
        if (step_options(first) == nullptr) {
            methods.push_back(first);
            continue;
        }
        for (const double dt : options.dt)
            for (const int substeps : options.substeps)
                for (const int passes : options.passes) {
                    StepOptions step = options.step;
                    step.dt = dt;
                    step.substeps = substeps;
                    step.passes = passes;
                    methods.push_back(make_method(wanted, step));
                }
    }
    return methods;
}

/// A guess at the work of a row, for the progress line only.
double weight(const Method& method, double until)
{
    const StepOptions* step = step_options(method);
    return step == nullptr ? study::event_run_in_steps : until / step->dt * step->substeps * step->passes + 1;
}

std::string label(const Method& method)
{
    std::string text(name(method));
    if (const StepOptions* step = step_options(method)) text += " dt " + study::step_text(step->dt);
    return text;
}

ReferenceSummary summary(const Reference& reference, double cpu_seconds)
{
    ReferenceSummary result;
    result.kind = reference.kind == Reference::Kind::closed_form ? "closed_form" : "multiprecision";
    result.bound = reference.bound;
    result.until = reference.until;
    result.reason = reference.reason;
    result.impacts = static_cast<std::int64_t>(reference.impacts.size());
    result.series = static_cast<std::int64_t>(reference.series.size());
    result.sample_times = reference.sample_times;
    result.cpu_seconds = cpu_seconds;
    for (const auto& states : reference.samples) {
        if (states.size() > max_track_spheres) break;
        auto& frame = result.tracks.emplace_back();
        for (const BodyState& s : states) {
            const Eigen::Vector3f x = s.position.cast<float>();
            frame.push_back({x[0], x[1], x[2]});
        }
    }
    return result;
}

/// Turns the progress of one row into that of the whole comparison.
class Progress {
public:
    Progress(const CompareOptions& options, const std::vector<Method>& methods) : options_(options)
    {
        for (const Method& method : methods) total_ += weight(method, options.until);
    }
    /// \return false to stop
    bool report(const std::string& what, double within_row) const
    {
        return !options_.on_progress || options_.on_progress({what, (done_ + within_row) / total_});
    }
    void row_done(double work) { done_ += work; }

private:
    const CompareOptions& options_;
    double done_ = 0, total_ = 0;
};

}  // namespace

double default_tolerance(const Scene& scene)
{
    using namespace study;
    const double radius = smallest_radius(scene);
    const bool sensible = pictured_tolerance >= least_pictured * radius && pictured_tolerance <= most_pictured * radius;
    return scene.units.length == "m" && sensible ? pictured_tolerance : default_tolerance_part * radius;
}

Comparison compare_methods(const Scene& scene, const CompareOptions& options)
{
    CAROM_EXPECT(options.until > 0 && options.repeats >= 1 && options.intervals >= 1);
    const std::vector<Method> methods = methods_to_run(options);
    Comparison result;
    result.until = options.until;
    result.tolerance = options.tolerance.value_or(default_tolerance(scene));
    result.sample_times = sample_grid(options.until, options.intervals);

    Progress progress(options, methods);
    progress.report("reference", 0);
    const double start = study::thread_cpu_seconds();
    const Reference reference = make_reference(scene, options.until, result.sample_times);
    result.reference = summary(reference, study::thread_cpu_seconds() - start);

    for (const Method& method : methods) {
        const double work = weight(method, options.until);
        const std::string what = label(method);
        study::RowTask task{scene, reference, method, {}, result.sample_times, {}};
        task.run.until = options.until;
        const double share = work / (1 + options.repeats);  // of the recorded run
        task.on_progress = [&](double time) { return progress.report(what, share * time / options.until); };
        // Asked here too: a run may be too short to ask itself.
        if (!progress.report(what, 0)) {
            result.interrupted = true;
            break;
        }
        study::RecordedRow recorded = study::record_row(task);
        if (recorded.interrupted) {
            result.interrupted = true;
            break;
        }
        std::vector<double> times =
            study::time_runs(task, recorded.cpu_seconds, {options.repeats, options.repeat_seconds});
        CompareRow& row = recorded.row;
        row.repeats = static_cast<int>(times.size());
        if (times.empty()) times.push_back(recorded.cpu_seconds);
        row.cpu_seconds = study::median(times);
        row.cpu_min = *std::min_element(times.begin(), times.end());
        row.cpu_max = *std::max_element(times.begin(), times.end());
        result.rows.push_back(std::move(row));
        progress.row_done(work);
    }
    result.verdict = verdict(scene, result);
    return result;
}

}  // namespace carom
