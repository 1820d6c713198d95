#include "study/search/step_search.hpp"

#include "study/convergence.hpp"
#include "study/fit_orders.hpp"
#include "study/row.hpp"
#include "study/row_family.hpp"
#include "study/search/step_scan.hpp"
#include "study/tolerances.hpp"
#include "study/verdict_words.hpp"
#include "study/words.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace carom::study {

namespace {

RowPlan with_step(const RowPlan& plan, double dt)
{
    RowPlan other = plan;
    std::visit(
        [dt](auto& method) {
            if constexpr (std::is_base_of_v<StepOptions, std::decay_t<decltype(method)>>) method.dt = dt;
        },
        other.method);
    return other;
}

/// Runs of one family, and what they said.
class Search {
public:
    /// \param known rows measured before; those of the family are tries
    Search(const RowMeasurer& measurer, const RowPlan& plan, double tolerance, std::span<const CompareRow> known);

    StepSearch run();

private:
    bool may_run(double dt) const;
    /// Runs `dt`; false where the search may not go on.
    bool try_step(double dt);
    /// Errors no longer fall, as far as steps were tried that nobody takes for the beginning.
    bool is_stalled() const;

    const RowMeasurer& measurer_;
    const RowPlan& plan_;
    double tolerance_, exact_, first_, largest_;
    StepScan scan_;
    double spent_ = 0, last_rate_ = 0;  ///< CPU time so far [s], of the last run for one step of it [s]
};

StepSearch::Try try_of(double dt, const CompareRow& row, double tolerance)
{
    StepSearch::Try result{dt, row.position_max, holds(row, tolerance)};
    if (result.error && !std::isfinite(*result.error)) result.error.reset();
    return result;
}

Search::Search(const RowMeasurer& measurer, const RowPlan& plan, double tolerance, std::span<const CompareRow> known)
    : measurer_(measurer),
      plan_(plan),
      tolerance_(tolerance),
      exact_(exact_error(measurer.scene, measurer.compared.reference.bound)),
      first_(step_options(plan.method)->dt),
      largest_(longest_searched_step(measurer.compared.until, first_)),
      scan_(first_, largest_)
{
    CompareRow own;
    describe(plan_, own);
    for (const CompareRow& row : known)
        if (row.dt && family_of(row) == family_of(own)) scan_.add(try_of(*row.dt, row, tolerance));
}

bool Search::may_run(double dt) const
{
    return scan_.tries().size() < most_tries && spent_ + last_rate_ * measurer_.compared.until / dt <= search_budget;
}

bool Search::try_step(double dt)
{
    if (!may_run(dt)) return false;
    const RowPlan plan = with_step(plan_, dt);
    measurer_.patience.name("step for the tolerance, " + label(plan.method));
    const RecordedRow recorded = record_row({measurer_.scene,
                                             measurer_.compared.reference,
                                             plan.method,
                                             {.until = measurer_.compared.until},
                                             measurer_.compared.times,
                                             measurer_.auditor.truth(),
                                             [&](double) { return measurer_.patience.lasts(); }});
    if (recorded.interrupted) return false;
    spent_ += recorded.cpu_seconds;
    last_rate_ = recorded.cpu_seconds * dt / measurer_.compared.until;
    scan_.add(try_of(dt, recorded.row, tolerance_));
    return measurer_.compared.reference.samples.size() > 1;  // else no step has an error
}

bool Search::is_stalled() const
{
    const std::vector<StepSearch::Try>& tries = scan_.tries();
    if (scan_.enough() || tries.back().dt < least_range_tried * tries.front().dt) return false;
    std::vector<StepError> points;
    for (auto each = tries.rbegin(); each != tries.rend(); ++each)
        if (each->error && *each->error > 0) points.push_back({each->dt, *each->error});
    return study::is_stalled(points, std::max(exact_, tolerance_));
}

StepSearch Search::run()
{
    for (auto dt = scan_.next(); dt && try_step(*dt) && !is_stalled();) dt = scan_.next();
    StepSearch result;
    CompareRow described;
    describe(plan_, described);
    result.method = described.method;
    result.variant = variant_text(described);
    result.tries = scan_.tries();
    result.is_complete = !scan_.next();
    result.largest = largest_;
    if (const auto enough = scan_.enough()) {
        result.row = measurer_.measure(with_step(plan_, *enough), [&](double) { return measurer_.patience.lasts(); });
        if (result.row) result.end = StepSearch::End::found;
    } else if (!result.tries.empty() && is_stalled()) {
        result.end = StepSearch::End::stalls;
    }
    return result;
}

}  // namespace

double longest_searched_step(double until, double longest)
{
    return std::max(longest, std::min(until / fewest_searched_steps, largest_searched * longest));
}

std::vector<RowPlan> families_of(const std::vector<RowPlan>& plans)
{
    std::vector<RowPlan> families;
    for (const RowPlan& plan : plans) {
        const StepOptions* step = step_options(plan.method);
        if (step == nullptr) continue;
        const auto known = std::find_if(families.begin(), families.end(), [&](const RowPlan& each) {
            const StepOptions& other = *step_options(each.method);
            return each.method.index() == plan.method.index() && other.substeps == step->substeps &&
                   other.passes == step->passes && other.order == step->order && other.integrator == step->integrator;
        });
        if (known == families.end())
            families.push_back(plan);
        else if (step->dt > step_options(known->method)->dt)
            *known = plan;
    }
    return families;
}

StepSearch find_step(const RowMeasurer& measurer, const RowPlan& plan, double tolerance,
                     std::span<const CompareRow> known)
{
    return Search(measurer, plan, tolerance, known).run();
}

}  // namespace carom::study
