#include "study/fit_orders.hpp"

#include "scene/tolerances.hpp"
#include "study/convergence.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace carom::study {

namespace {

/// Method and variant: what rows that differ in their step alone have in common.
using Name = std::pair<std::string, std::string>;
using Errors = std::map<Name, std::vector<StepError>>;

Name name_of(const CompareRow& row)
{
    return {row.method, variant_text(row)};
}

/// Finite errors. Where steps were searched for, those of all tries, in which the rows are.
Errors errors_of(const Comparison& comparison)
{
    Errors all;
    const auto add = [&](const Name& name, double dt, std::optional<double> error) {
        if (error && std::isfinite(*error) && *error > 0) all[name].push_back({dt, *error});
    };
    for (const StepSearch& search : comparison.searches)
        for (const StepSearch::Try& each : search.tries) add({search.method, search.variant}, each.dt, each.error);
    const auto is_searched = [&](const Name& name) {
        return std::any_of(comparison.searches.begin(), comparison.searches.end(),
                           [&](const StepSearch& each) { return Name(each.method, each.variant) == name; });
    };
    for (const CompareRow& row : comparison.rows)
        if (row.dt && !is_searched(name_of(row))) add(name_of(row), *row.dt, row.position_max);
    return all;
}

/// Whether a step within the tolerance was found: then errors fell far enough, however they scatter.
bool is_found(const Comparison& comparison, const Name& name)
{
    return std::any_of(comparison.searches.begin(), comparison.searches.end(), [&](const StepSearch& each) {
        return Name(each.method, each.variant) == name && each.end == StepSearch::End::found;
    });
}

}  // namespace

double exact_error(const Scene& scene, double reference_bound)
{
    return std::max(reference_bound, declared_contact * smallest_radius(scene));
}

std::vector<Convergence> fit_orders(const Scene& scene, const Comparison& comparison)
{
    const double exact = exact_error(scene, comparison.reference.bound);
    Errors errors = errors_of(comparison);
    std::vector<Convergence> all;
    for (const CompareRow& row : comparison.rows) {  // in the order of the rows
        const auto family = errors.find(name_of(row));
        if (!row.dt || family == errors.end()) continue;
        std::vector<StepError> points = std::move(family->second);
        errors.erase(family);
        std::sort(points.begin(), points.end(), [](const StepError& a, const StepError& b) { return a.dt > b.dt; });
        const bool stalled = is_stalled(points, exact) && !is_found(comparison, name_of(row));
        std::erase_if(points, [&](const StepError& each) { return each.error <= exact; });
        if (points.empty() || points.front().dt < least_fitted_range * points.back().dt) continue;
        const std::optional<FittedOrder> fit = fitted_order(points);
        if (!fit) continue;
        all.push_back(
            {row.method, variant_text(row), fit->order, fit->uncertainty, fit->steps, stalled, points.back().error});
    }
    return all;
}

}  // namespace carom::study
