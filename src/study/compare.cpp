#include "core/expect.hpp"
#include "core/patience.hpp"
#include "reference/reference.hpp"
#include "study/audit.hpp"
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

/// The longest step among the methods; 0 without a discrete one [time].
double longest_step(const std::vector<Method>& methods)
{
    double longest = 0;
    for (const Method& method : methods)
        if (const StepOptions* step = step_options(method)) longest = std::max(longest, step->dt);
    return longest;
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

/// Runs for the time, and what they say of it.
void time_row(const study::RowTask& task, const CompareOptions& options, study::RecordedRow& recorded)
{
    std::vector<double> times = study::time_runs(task, recorded.cpu_seconds, {options.repeats, options.repeat_seconds});
    CompareRow& row = recorded.row;
    row.repeats = static_cast<int>(times.size());
    if (times.empty()) times.push_back(recorded.cpu_seconds);
    row.cpu_seconds = study::median(times);
    row.cpu_min = *std::min_element(times.begin(), times.end());
    row.cpu_max = *std::max_element(times.begin(), times.end());
}

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

    const double start = study::thread_cpu_seconds();
    const Reference reference = make_reference(scene, options.until, result.sample_times, options.on_progress);
    result.reference = summary(reference, study::thread_cpu_seconds() - start);
    result.interrupted = reference.stopped;

    std::optional<study::Auditor> auditor;  // none where only the event method runs
    if (const double longest = longest_step(methods); longest > 0 && !result.interrupted) {
        auditor.emplace(scene, options.until, longest, options.on_progress);
        result.audit = auditor->summary();
        result.interrupted = auditor->stopped();
    }

    double total = 0, done = 0;
    for (const Method& method : methods) total += weight(method, options.until);
    Patience patience(options.on_progress);
    patience.begin("methods", total, "steps");
    for (const Method& method : methods) {
        // Asked here too: a run may be too short to ask itself.
        patience.name(label(method));
        if (result.interrupted || !patience.lasts(done)) break;
        const double work = weight(method, options.until);
        study::RowTask task{scene, reference, method, {}, result.sample_times, {}};
        task.run.until = options.until;
        const double one_run = work / (1 + options.repeats);
        task.on_progress = [&](double time) { return patience.lasts(done + one_run * time / options.until); };
        study::RecordedRow recorded = study::record_row(task);
        if (recorded.interrupted) break;
        done += one_run;
        task.on_progress = [&](double) { return patience.lasts(); };
        if (step_options(method) != nullptr) recorded.row.audit = auditor->audit(method, patience);
        time_row(task, options, recorded);
        result.rows.push_back(std::move(recorded.row));
        done += work - one_run;
    }
    result.interrupted = result.interrupted || patience.ended();
    result.verdict = verdict(scene, result);
    return result;
}

}  // namespace carom
