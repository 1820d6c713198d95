#include "cli/search_table.hpp"

#include "cli/tables.hpp"
#include "study/search/step_scan.hpp"
#include "study/tolerances.hpp"
#include "study/words.hpp"

#include <vector>

namespace carom::cli {

namespace {

using study::step_text;

std::string step_cell(const std::optional<StepSearch::Try>& tried)
{
    return tried ? step_text(tried->dt) : "-";
}

std::string error_cell(const std::optional<StepSearch::Try>& tried, const std::string& unit)
{
    return tried && tried->error ? study::length_text(*tried->error, unit) : "-";
}

std::vector<std::string> line(const StepSearch& search, const std::string& unit)
{
    const study::SearchFigures figures = study::figures_of(search);
    const std::string tried = std::to_string(search.tries.size());
    const std::string smallest = search.tries.empty() ? "-" : step_text(search.tries.front().dt);
    const std::string method = search.method + search.variant;
    if (!search.row) return {method, "-", tried, smallest, "-", "-", step_cell(figures.fails), "-"};
    return {method,
            step_text(*search.row->dt),
            tried,
            smallest,
            std::to_string(figures.held),
            study::length_text(figures.worst_error, unit),
            step_cell(figures.too_far),
            error_cell(figures.too_far, unit)};
}

}  // namespace

std::string search_table(const Scene& scene, const Comparison& comparison)
{
    if (comparison.searches.empty()) return "";
    std::vector<std::vector<std::string>> lines{
        {"method", "enough", "tried", "smallest", "at or below", "worst error", "first that fails", "its error"}};
    for (const StepSearch& search : comparison.searches) lines.push_back(line(search, scene.units.length));
    return aligned(lines, 1) +
           "\nenough: the step from which all smaller ones tried keep within the tolerance; at or "
           "below: how many these are, and the worst of\n  their errors; first that fails: the "
           "smallest step tried that does not keep within it. One method's search ends after " +
           study::seconds_text(study::search_budget) + " of runs.\n\n";
}

}  // namespace carom::cli
