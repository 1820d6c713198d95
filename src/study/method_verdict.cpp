#include "study/method_verdict.hpp"

#include "study/row_family.hpp"
#include "study/search/search_words.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace carom::study {

namespace {

using Rows = std::vector<const CompareRow*>;

Rows rows_of(const Comparison& comparison, const std::string& method)
{
    Rows rows;
    for (const CompareRow& row : comparison.rows)
        if (row.dt && row.method == method) rows.push_back(&row);
    return rows;
}

bool smaller_error(const CompareRow& a, const CompareRow* b)
{
    const std::optional<double> error = verdict_error(a);
    return error && std::isfinite(*error) && (b == nullptr || *error < *verdict_error(*b));
}

/// A range of steps that closes in on what is enough, as an option.
std::string finer_range(const CompareRow& from, const CompareRow& to)
{
    const std::string rule = *from.dt > linear_range_factor * *to.dt ? "log5" : "lin5";
    return "--dt " + step_text(*from.dt) + ":" + step_text(*to.dt) + ":" + rule;
}

std::string enough_text(const VerdictWords& words, const StepBracket& found, std::size_t tried)
{
    const CompareRow& row = *found.enough;
    const std::string within = " within " + words.tolerance();
    std::string text;
    if (tried == 1)
        text = "the only step tried, dt = " + VerdictWords::setting(row) + ", keeps" + within;
    else if (found.too_far == nullptr)
        text = "all steps tried keep" + within + ", the largest being dt = " + VerdictWords::setting(row);
    else if (found.smaller == 0)
        text = "of the steps tried, only the smallest, dt = " + VerdictWords::setting(row) + ", keeps" + within;
    else
        text = "of the steps tried, dt = " + VerdictWords::setting(row) +
               " is the largest from which all smaller ones keep" + within;
    text += "; it costs " + words.cost(row);
    text += audit_clause(row);
    if (found.too_far == nullptr) return text;
    text += "; the next larger, " + VerdictWords::setting(*found.too_far) + ", " + words.fault(*found.too_far);
    if (*found.too_far->dt > fine_bracket * *row.dt)
        text += " (to close in, try " + finer_range(*found.too_far, row) + ")";
    return text;
}

/// The next smaller step that does not hold.
const CompareRow* failing_below(const CompareRow& row, const Rows& rows, double tolerance)
{
    const CompareRow* fails = nullptr;
    for (const CompareRow* each : rows)
        if (*each->dt < *row.dt && family_of(*each) == family_of(row) && !holds(*each, tolerance) &&
            (fails == nullptr || *each->dt > *fails->dt))
            fails = each;
    return fails;
}

}  // namespace

StepBracket step_bracket(const Comparison& comparison, const std::string& method)
{
    std::map<Family, Rows> families;
    for (const CompareRow* row : rows_of(comparison, method)) families[family_of(*row)].push_back(row);
    StepBracket best;
    for (auto& family : families) {
        Rows& rows = family.second;
        std::stable_sort(rows.begin(), rows.end(),
                         [](const CompareRow* a, const CompareRow* b) { return *a->dt < *b->dt; });
        const auto fails = std::find_if(rows.begin(), rows.end(),
                                        [&](const CompareRow* row) { return !holds(*row, comparison.tolerance); });
        if (fails == rows.begin()) continue;
        StepBracket here{*std::prev(fails), fails == rows.end() ? nullptr : *fails,
                         static_cast<std::size_t>(fails - rows.begin()) - 1};
        if (best.enough == nullptr || here.enough->cpu_seconds < best.enough->cpu_seconds) best = here;
    }
    return best;
}

const CompareRow* cheapest_stepper(const Comparison& comparison)
{
    const CompareRow* cheapest = nullptr;
    for (const CompareRow& row : comparison.rows) {
        if (!row.dt) continue;
        const CompareRow* enough = step_bracket(comparison, row.method).enough;
        if (enough != nullptr && (cheapest == nullptr || enough->cpu_seconds < cheapest->cpu_seconds))
            cheapest = enough;
    }
    return cheapest;
}

const CompareRow* best_stepper(const Comparison& comparison)
{
    const CompareRow* best = nullptr;
    for (const CompareRow& row : comparison.rows)
        if (row.dt && smaller_error(row, best)) best = &row;
    return best;
}

std::string method_sentence(const VerdictWords& words, const std::string& method)
{
    const double tolerance = words.comparison().tolerance;
    const Rows rows = rows_of(words.comparison(), method);
    const CompareRow *best = nullptr, *blind = nullptr, *blown = nullptr, *lucky = nullptr;
    for (const CompareRow* row : rows) {
        if (lost_impacts(*row) > 0 && (blind == nullptr || lost_impacts(*row) > lost_impacts(*blind))) blind = row;
        if (row->status != Status::reached_end || !std::isfinite(verdict_error(*row).value_or(0))) {
            if (blown == nullptr) blown = row;
            continue;
        }
        if (smaller_error(*row, best)) best = row;
        if (holds(*row, tolerance) && (lucky == nullptr || *row->dt > *lucky->dt)) lucky = row;
    }
    const StepBracket found = step_bracket(words.comparison(), method);
    const CompareRow* fails = lucky == nullptr ? nullptr : failing_below(*lucky, rows, tolerance);
    const auto price = [&](const CompareRow& row) {
        return words.length(*verdict_error(row)) + " at dt = " + VerdictWords::setting(row) + ", " + words.cost(row);
    };
    std::string text = method + words.while_known() + ": ";
    if (found.enough != nullptr)
        text += enough_text(words, found, rows.size());
    else if (fails != nullptr)
        text += "dt = " + VerdictWords::setting(*lucky) + " keeps within " + words.tolerance() + " (" +
                words.cost(*lucky) + "), but the smaller " + VerdictWords::setting(*fails) + " " + words.fault(*fails) +
                ": no step tried is safe";
    else if (best == nullptr)
        text += "no step tried gave a finite answer to the end";
    else if (*verdict_error(*best) <= tolerance)
        text += "no step tried keeps within " + words.tolerance() + " without missing an impact (" + price(*best) + ")";
    else
        text += "no step tried keeps within " + words.tolerance() + " (best " + price(*best) + ")";
    const CompareRow* told = found.enough != nullptr ? found.too_far : fails;
    if (blind != nullptr && blind != told)
        text += "; it misses " + VerdictWords::share(lost_impacts(*blind), *blind) +
                " at dt = " + VerdictWords::setting(*blind);
    if (blown != nullptr && best != nullptr && blown != told)
        text += "; at dt = " + VerdictWords::setting(*blown) + " it " + words.fault(*blown);
    return text + ".";
}

}  // namespace carom::study
