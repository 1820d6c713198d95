#include "study/step_search.hpp"

#include "study/convergence.hpp"
#include "study/fit_orders.hpp"
#include "study/row.hpp"
#include "study/row_family.hpp"
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
    Search(const RowMeasurer& measurer, const RowPlan& plan, double tolerance)
        : measurer_(measurer), plan_(plan), tolerance_(tolerance)
    {
        exact_ = exact_error(measurer.scene, measurer.compared.reference.bound);
    }

    /// \param known rows measured before
    StepSearch run(std::span<const CompareRow> known);

private:
    struct Probe {
        double dt;
        double error;  ///< infinite where there is none [length]
        bool holds;
    };

    /// Whether `dt` holds; false too where the search may not go on.
    bool holds(double dt);
    bool may_run(double dt) const;
    bool is_over() const { return ended_ || static_cast<int>(probes_.size()) >= most_probes; }
    /// From the largest step to the smallest, those with an error.
    std::vector<StepError> errors() const;
    double failing_below(std::span<const CompareRow> known) const;
    double search_down(double dt);
    double search_up(double dt);
    void bisect();

    const RowMeasurer& measurer_;
    const RowPlan& plan_;
    double tolerance_, exact_ = 0;
    std::vector<Probe> probes_;
    double spent_ = 0, last_rate_ = 0;  ///< CPU time so far [s], of the last run for one step of it [s]
    bool ended_ = false;
    double enough_ = 0, too_far_ = 0;  ///< 0 as long as there is none [time]
};

bool Search::may_run(double dt) const
{
    return spent_ + last_rate_ * measurer_.compared.until / dt <= search_budget;
}

bool Search::holds(double dt)
{
    if (is_over()) return false;
    if (!may_run(dt)) {
        ended_ = true;
        return false;
    }
    const RowPlan plan = with_step(plan_, dt);
    measurer_.patience.name("step for the tolerance, " + label(plan.method));
    const RecordedRow recorded = record_row({measurer_.scene,
                                             measurer_.compared.reference,
                                             plan.method,
                                             {.until = measurer_.compared.until},
                                             measurer_.compared.times,
                                             measurer_.auditor.truth(),
                                             [&](double) { return measurer_.patience.lasts(); }});
    if (recorded.interrupted) {
        ended_ = true;
        return false;
    }
    spent_ += recorded.cpu_seconds;
    last_rate_ = recorded.cpu_seconds * dt / measurer_.compared.until;
    const double error = recorded.row.position_max.value_or(INFINITY);
    probes_.push_back({dt, error, study::holds(recorded.row, tolerance_)});
    return probes_.back().holds;
}

std::vector<StepError> Search::errors() const
{
    std::vector<StepError> points;
    for (const Probe& each : probes_)
        if (std::isfinite(each.error) && each.error > 0) points.push_back({each.dt, each.error});
    std::sort(points.begin(), points.end(), [](const StepError& a, const StepError& b) { return a.dt > b.dt; });
    return points;
}

/// The first step below `dt` that holds; 0 if there is none.
double Search::search_down(double dt)
{
    for (double step = dt / search_stride; !is_over(); step /= search_stride) {
        if (holds(step)) return step;
        if (!is_over()) too_far_ = step;
        if (is_stalled(errors(), std::max(exact_, tolerance_))) return 0;
    }
    return 0;
}

/// The last step from `dt` on up that holds.
double Search::search_up(double dt)
{
    const double largest = longest_searched_step(measurer_.compared.until, dt);
    while (dt < largest && !is_over()) {
        const double step = std::min(largest, dt * search_stride);
        if (!holds(step)) {
            if (!is_over()) too_far_ = step;
            return dt;
        }
        dt = step;
    }
    return dt;
}

void Search::bisect()
{
    while (too_far_ > search_bracket * enough_ && !is_over()) {
        const double middle = std::sqrt(enough_ * too_far_);
        const bool good = holds(middle);
        if (ended_) return;
        (good ? enough_ : too_far_) = middle;
    }
}

/// The largest step below `enough_` of a row of this family that does not hold; 0 if there is none.
double Search::failing_below(std::span<const CompareRow> known) const
{
    CompareRow own;
    describe(plan_, own);
    double largest = 0;
    for (const CompareRow& row : known)
        if (row.dt && *row.dt < enough_ && family_of(row) == family_of(own) && !study::holds(row, tolerance_))
            largest = std::max(largest, *row.dt);
    return largest;
}

StepSearch Search::run(std::span<const CompareRow> known)
{
    const double first = step_options(plan_.method)->dt;
    const bool first_holds = holds(first);
    if (!first_holds) too_far_ = first;
    enough_ = first_holds ? search_up(first) : search_down(first);
    while (enough_ > 0 && !is_over()) {
        if (too_far_ > 0) bisect();
        // One step that holds proves nothing where a smaller one fails.
        double fails = failing_below(known);
        for (const double part : {probe_below, probe_further_below})
            if (!is_over() && !holds(part * enough_) && !ended_) fails = part * enough_;
        if (fails == 0) break;
        too_far_ = fails;
        enough_ = search_down(fails);
    }
    StepSearch result;
    CompareRow described;
    describe(plan_, described);
    result.method = described.method;
    result.variant = variant_text(described);
    const std::vector<StepError> points = errors();
    for (const StepError& p : points) {
        if (result.best_error && *result.best_error <= p.error) continue;
        result.best_error = p.error;
        result.best_step = p.dt;
    }
    for (const Probe& each : probes_)
        if (each.dt == too_far_ && std::isfinite(each.error)) result.too_far_error = each.error;
    if (too_far_ > 0) result.too_far = too_far_;
    if (enough_ > 0) {
        result.end = StepSearch::End::found;
        const auto row =
            measurer_.measure(with_step(plan_, enough_), [&](double) { return measurer_.patience.lasts(); });
        if (row) result.row = *row;
    } else if (is_stalled(points, std::max(exact_, tolerance_))) {
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
    return Search(measurer, plan, tolerance).run(known);
}

}  // namespace carom::study
