#include "core/expect.hpp"
#include "core/patience.hpp"
#include "study/audit.hpp"
#include "study/clock.hpp"
#include "study/compared_reference.hpp"
#include "study/row.hpp"
#include "study/timing.hpp"
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

ReferenceSummary summary(const study::ComparedReference& compared, double cpu_seconds)
{
    const Reference& reference = compared.reference;
    ReferenceSummary result;
    result.kind = reference.kind == Reference::Kind::closed_form ? "closed_form" : "multiprecision";
    result.bound = reference.bound;
    result.until = reference.until;
    result.reason = compared.reason;
    result.impacts = static_cast<std::int64_t>(reference.impacts.size());
    result.series = static_cast<std::int64_t>(reference.series.size());
    result.cpu_seconds = cpu_seconds;
    for (std::size_t moment = 0; moment < reference.samples.size(); ++moment) {
        if (compared.times.goes_on(moment)) continue;
        result.sample_times.push_back(compared.times.grid[compared.times.sample[moment]]);
        const std::vector<BodyState>& states = reference.samples[moment];
        if (states.size() > max_track_spheres) continue;
        auto& frame = result.tracks.emplace_back();
        for (const BodyState& s : states) {
            const Eigen::Vector3f x = s.position.cast<float>();
            frame.push_back({x[0], x[1], x[2]});
        }
    }
    return result;
}

/// Runs for the time, and what they say of it.
void time_row(const study::TimedRun& run, const CompareOptions& options, study::RecordedRow& recorded)
{
    std::vector<double> times = study::time_runs(run, recorded.cpu_seconds, {options.repeats, options.repeat_seconds});
    CompareRow& row = recorded.row;
    row.repeats = static_cast<int>(times.size());
    if (times.empty()) times.push_back(recorded.cpu_seconds);
    const study::MedianTime time = study::median_time(times);
    row.cpu_seconds = time.median;
    row.cpu_min = time.min;
    row.cpu_max = time.max;
    row.cpu_low = time.low;
    row.cpu_high = time.high;
}

/// An event run that stops beyond what is compared says so all the same.
void tell_how_it_ends(const study::Truth& whole, double until, CompareRow& row)
{
    if (row.dt || row.status != Status::reached_end || whole.status == Status::reached_end || whole.until >= until)
        return;
    row.status = whole.status;
    row.message = whole.message;
    row.time = whole.until;
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

    const double start = study::thread_cpu_seconds();
    const study::ComparedReference compared =
        study::make_compared_reference(scene, options.until, options.intervals, options.on_progress);
    result.reference = summary(compared, study::thread_cpu_seconds() - start);
    result.compared_until = compared.until;
    result.sample_times = compared.times.grid;
    result.interrupted = compared.reference.stopped;

    study::Auditor auditor(
        scene, options.until, longest_step(methods),
        result.interrupted ? OnProgress([](const Progress&) { return false; }) : options.on_progress);
    result.audit = auditor.summary();
    result.interrupted = result.interrupted || auditor.stopped();

    double total = 0, done = 0;
    for (const Method& method : methods) total += weight(method, compared.until);
    Patience patience(options.on_progress);
    patience.begin("methods", total, "steps");
    for (const Method& method : methods) {
        // Asked here too: a run may be too short to ask itself.
        patience.name(label(method));
        if (result.interrupted || !patience.lasts(done)) break;
        const double work = weight(method, compared.until);
        study::RowTask task{scene, compared.reference, method, {}, compared.times, auditor.truth(), {}};
        task.run.until = compared.until;
        const double one_run = work / (1 + options.repeats);
        task.on_progress = [&](double time) { return patience.lasts(done + one_run * time / compared.until); };
        study::RecordedRow recorded = study::record_row(task);
        if (recorded.interrupted) break;
        done += one_run;
        if (step_options(method) != nullptr) recorded.row.audit = auditor.audit(method, patience);
        tell_how_it_ends(auditor.truth(), options.until, recorded.row);
        time_row({scene, method, task.run, compared.times.asked, [&](double) { return patience.lasts(); }}, options,
                 recorded);
        result.rows.push_back(std::move(recorded.row));
        done += work - one_run;
    }
    result.interrupted = result.interrupted || patience.ended();
    result.verdict = verdict(scene, result);
    return result;
}

}  // namespace carom
