#include "core/expect.hpp"
#include "core/patience.hpp"
#include "study/clock.hpp"
#include "study/fit_orders.hpp"
#include "study/measure_row.hpp"
#include "study/peer_row.hpp"
#include "study/search/step_search.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <carom/study.hpp>

namespace carom {

namespace {

/// A guess at the work of a row, for the progress line only.
double weight(const Method& method, double until)
{
    const StepOptions* step = step_options(method);
    return step == nullptr ? study::event_run_in_steps : until / step->dt * step->substeps * step->passes + 1;
}

Convention told(const ReferenceConvention& met)
{
    Convention result{met.time, met.bodies, {}, met.differ};
    for (const ReferenceConvention::Answer& answer : met.answers)
        result.answers.push_back({answer.impact_operator, answer.velocities});
    return result;
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
    for (const ReferenceConvention& met : reference.conventions) result.conventions.push_back(told(met));
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

/// The comparison's rows, as far as patience lasts.
void measure_rows(const study::RowMeasurer& measurer, const std::vector<study::RowPlan>& plans, Comparison& result)
{
    const double until = measurer.compared.until;
    double total = 0, done = 0;
    for (const study::RowPlan& plan : plans) total += weight(plan.method, until);
    Patience& patience = measurer.patience;
    patience.begin("methods", total, "steps");
    for (const study::RowPlan& plan : plans) {
        // Asked here too: a run may be too short to ask itself.
        patience.name(study::label(plan.method));
        if (result.interrupted || !patience.lasts(done)) return;
        const double work = weight(plan.method, until), one_run = work / (1 + measurer.options.repeats);
        std::optional<CompareRow> row =
            measurer.measure(plan, [&](double time) { return patience.lasts(done + one_run * time / until); });
        if (!row) return;
        result.rows.push_back(std::move(*row));
        done += work;
    }
}

/// The rows of engines that are none of carom's, at each step.
void measure_peers(const study::RowMeasurer& measurer, Comparison& result)
{
    const CompareOptions& options = measurer.options;
    Patience& patience = measurer.patience;
    patience.begin("other engines", static_cast<double>(options.peers.size() * options.dt.size()), "rows");
    double done = 0;
    for (const Peer& peer : options.peers)
        for (const double dt : options.dt) {
            patience.name(peer.name + " dt " + study::step_text(dt));
            if (!patience.lasts(done++)) return;
            std::optional<CompareRow> row = study::measure_peer(measurer, peer, dt);
            if (!row) return;
            result.rows.push_back(std::move(*row));
        }
}

/// The largest step of each method that keeps within the tolerance; the rows found join the others.
void search_steps(const study::RowMeasurer& measurer, const std::vector<study::RowPlan>& plans, Comparison& result)
{
    const std::vector<study::RowPlan> families = study::families_of(plans);
    measurer.patience.begin("steps for the tolerance", static_cast<double>(families.size()), "methods");
    for (const study::RowPlan& family : families) {
        if (!measurer.patience.lasts(static_cast<double>(result.searches.size()))) return;
        result.searches.push_back(study::find_step(measurer, family, result.tolerance, result.rows));
    }
    for (const StepSearch& search : result.searches)
        if (search.row) result.rows.push_back(*search.row);
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
    const std::vector<study::RowPlan> plans = study::rows_to_run(scene, options);
    Comparison result;
    result.until = options.until;
    result.tolerance = options.tolerance.value_or(default_tolerance(scene));
    result.is_default_tolerance = !options.tolerance;

    const double start = study::thread_cpu_seconds();
    const study::ComparedReference compared =
        study::make_compared_reference(scene, options.until, options.intervals, options.on_progress);
    result.reference = summary(compared, study::thread_cpu_seconds() - start);
    result.compared_until = compared.until;
    result.sample_times = compared.times.grid;
    result.interrupted = compared.reference.stopped;

    const OnProgress stop = [](const Progress&) { return false; };
    const double longest = study::longest_step(plans);
    const double longest_tried = options.search_steps ? study::longest_searched_step(compared.until, longest) : longest;
    study::Auditor auditor(scene, options.until, longest_tried, result.interrupted ? stop : options.on_progress);
    result.audit = auditor.summary();
    result.interrupted = result.interrupted || auditor.stopped();

    Patience patience(options.on_progress);
    const study::RowMeasurer measurer{scene, options, compared, auditor, patience};
    measure_rows(measurer, plans, result);
    if (!result.interrupted) measure_peers(measurer, result);
    if (options.search_steps && !result.interrupted) search_steps(measurer, plans, result);
    result.interrupted = result.interrupted || patience.ended();
    result.convergence = study::fit_orders(scene, result);
    result.verdict = verdict(scene, result);
    return result;
}

}  // namespace carom
